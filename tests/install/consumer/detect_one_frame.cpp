// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "fallen/detection/detector.hpp"
#include "fallen/messages/model_files.hpp"

int main(int, char** argv) {
  const fallen::Model model = fallen::LoadModel(argv[1]);
  fallen::DetectorConfig config;
  config.segmentation = model.segmentation;
  fallen::Detector detector(model, config, fallen::BackgroundSubtractor(config.background));

  fallen::Frame frame;  // a wall 2 m ahead; a real one comes from a depth camera
  frame.image.intrinsics = {320, 240, 290, 290, 159.5, 119.5};
  frame.image.depth.assign(320 * 240, 2000);
  const fallen::FrameResult result = detector.Detect(frame);
  int persons = 0;
  for (const fallen::PersonHypothesis& person : result.decision.hypotheses)
    if (person.is_person) ++persons;
  std::printf("%zu cells, %d persons\n", result.foreground.map.cells.size(), persons);
}
