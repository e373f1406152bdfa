// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/evaluated_method.hpp"

#include <utility>

namespace fallen {
namespace {

class OurDetector : public EvaluatedMethod {
 public:
  explicit OurDetector(const DetectorOptions& options) : detector_(MakeDetector(options)) {}

  MethodFrame Detect(const Frame& frame) override {
    FrameResult result = detector_.Detect(frame);
    return {std::move(result.decision), std::move(result.foreground.map),
            result.milliseconds.total};
  }

 private:
  Detector detector_;
};

}  // namespace

MethodChoice DetectorMethod(const std::string& name, const nlohmann::json::json_pointer& place,
                            const DetectorOptions& options) {
  return {name, place, [options] { return std::make_unique<OurDetector>(options); }};
}

}  // namespace fallen
