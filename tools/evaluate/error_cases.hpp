// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/messages/conversions.hpp"

namespace fallen {

/// One thing that a method is wrong, or nearly wrong, about: a fallen person or what is taken for
/// one, in however many frames of a recording.
struct ErrorCase {
  bool is_miss = false;  ///< a fallen person; else something that is none
  /// "fallen_person" of a miss; of a false alarm the category of what is labelled there ("dog"),
  /// "beside_fallen_person" by the box of one, "unlabelled" where there is nothing.
  std::string kind;
  std::string log;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< map frame [m]; of a person its box's middle
  double probability = 0;     ///< highest of any frame; 0 where no cluster was ever there
  std::int64_t frames = 0;    ///< of a person those where it counts as present, else those flagged
  std::int64_t at_fault = 0;  ///< of them, those that are wrong at the threshold in force
  std::int64_t frame = 0;     ///< the one to look at: a miss seen best, a false alarm at its worst
};

/// Gathers the cases of one recording, frame by frame, by the rules of JudgeFrame. Hypotheses
/// within 1 m of each other along the floor are about one thing.
class CaseCollector {
 public:
  explicit CaseCollector(std::string log) : log_(std::move(log)) {}

  /// @param number        Of the frame in the recording, from 0.
  /// @param cells_in_box  CountCellsInBox of the frame.
  void Add(std::int64_t number, const Decision& decision, const GroundTruth& truth,
           int cells_in_box);

  /// All cases so far, in order of appearance; persons that were never present are none.
  std::vector<ErrorCase> cases() const;

 private:
  struct Seen {
    ErrorCase what;
    double rank = -1;  ///< of the frame to look at
  };
  void AddPerson(std::int64_t number, const Decision& decision, const GroundTruth& truth,
                 int cells_in_box);
  void AddFalseAlarm(std::int64_t number, const PersonHypothesis& hypothesis,
                     const GroundTruth& truth, double min_probability);
  Seen& Find(bool is_miss, const Eigen::Vector3d& place);

  std::string log_;
  std::vector<Seen> seen_;
};

/// The worst cases of all recordings: of the persons those with the lowest best probability, of the
/// false alarms those with the highest.
struct WorstCases {
  std::vector<ErrorCase> misses;
  std::vector<ErrorCase> false_alarms;
};

/// @param count  Of each at most so many. Persons found in every frame, and things that stay below
/// the threshold, are no errors and left out.
WorstCases PickWorstCases(std::vector<ErrorCase> cases, std::size_t count);

/// `{"recording": …, "frame": …, "place": [x, y, z], "p": …, "kind": …, "frames": …, "at_fault":
/// …}`
nlohmann::json ToJson(const ErrorCase& error);

}  // namespace fallen
