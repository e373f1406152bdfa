// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/evaluated_method.hpp"

#include <utility>

#include "fallen/detection/map_update.hpp"
#include "fallen/detection/stopwatch.hpp"
#include "fallen/service/configuration.hpp"
#include "tools/common/baseline_setup.hpp"

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

class Baseline : public EvaluatedMethod {
 public:
  Baseline(const std::string& model, const DetectorOptions& options)
      : baseline_(MakeBaselineDetector(model, options)),
        configuration_(LoadConfiguration(options.config)),
        mapper_(configuration_.ndt) {}

  MethodFrame Detect(const Frame& frame) override {
    MethodFrame result;
    Stopwatch stopwatch;
    result.decision = baseline_.Detect(frame);
    result.milliseconds = stopwatch.LapMilliseconds();
    result.local_map = UpdateMap(mapper_, frame, configuration_.ground);
    return result;
  }

 private:
  BaselineDetector baseline_;
  Configuration configuration_;
  NdtMapper mapper_;
};

}  // namespace

MethodChoice DetectorMethod(const std::string& name, const nlohmann::json::json_pointer& place,
                            const DetectorOptions& options) {
  return {name, place, [options] { return std::make_unique<OurDetector>(options); }};
}

MethodChoice BaselineMethod(const std::string& model, const DetectorOptions& options) {
  return {"baseline", nlohmann::json::json_pointer("/baseline"),
          [model, options] { return std::make_unique<Baseline>(model, options); }};
}

}  // namespace fallen
