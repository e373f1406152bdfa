// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "fallen/detection/detector.hpp"
#include "tools/common/detector_setup.hpp"

namespace fallen {

/// What a method makes of one frame, as the protocol needs it.
struct MethodFrame {
  Decision decision;
  /// The local NDT map, in the decision's frame: its cells in the labelled box say if a person
  /// counts as present, also for methods that use no map (the paper, Sec. IV-B).
  NdtMap local_map;
  double milliseconds = 0;  ///< taken by the method itself
};

/// A way to find fallen persons in a recording, fed frame by frame in order.
class EvaluatedMethod {
 public:
  virtual ~EvaluatedMethod() = default;

  /// @throws std::invalid_argument if the frame is malformed.
  virtual MethodFrame Detect(const Frame& frame) = 0;
};

/// A method to measure: what it is called, and how to make a fresh one for each recording.
struct MethodChoice {
  std::string name;                    ///< of its curve
  nlohmann::json::json_pointer place;  ///< of its figures in the report
  std::function<std::unique_ptr<EvaluatedMethod>()> make;
};

/// The detector that `options` describe. Making one throws as MakeDetector does.
MethodChoice DetectorMethod(const std::string& name, const nlohmann::json::json_pointer& place,
                            const DetectorOptions& options);

/// The comparison detector, on the same frames: `model` as MakeBaselineDetector takes it. The local
/// map is what `options` make of the depth images, as for the detector.
MethodChoice BaselineMethod(const std::string& model, const DetectorOptions& options);

}  // namespace fallen
