// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/evaluation_report.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>

namespace fallen {
namespace {

// Rates and miss rates of zero have no logarithm: they are drawn at the edge of the plot.
constexpr double kLowestRate = 1e-3;
constexpr double kLowestMissRate = 1e-3;

std::string GnuplotQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

std::string PlotScript(const std::vector<NamedCurve>& curves, const std::filesystem::path& path) {
  const bool is_png = path.extension() == ".png";
  std::string script = is_png ? "set terminal pngcairo size 900,650 font 'sans,11'\n"
                              : "set terminal svg size 900,650 font 'sans,14' background 'white'\n";
  script += "set output " + GnuplotQuoted(path.string()) + "\n";
  script +=
      "set logscale xy\nset xrange [1e-3:10]\nset yrange [1e-3:1]\nset grid xtics ytics mxtics\n"
      "set format x '10^{%L}'\nset format y '%g'\nset key bottom left box opaque\n"
      "set xlabel 'false positives per frame'\nset ylabel 'miss rate'\n"
      "set arrow from 0.01,1e-3 to 0.01,1 nohead dashtype 2 linecolor rgb '#888888'\n";
  std::string plots, data;
  for (const NamedCurve& named : curves) {
    plots += (plots.empty() ? "plot " : ", ") + std::string("'-' with steps linewidth 2 title ") +
             GnuplotQuoted(named.name);
    for (const OperatingPoint& point : named.curve.points)
      data += std::to_string(std::max(kLowestRate, point.false_positives_per_frame)) + " " +
              std::to_string(std::max(kLowestMissRate, point.miss_rate)) + "\n";
    data += "e\n";
  }
  return script + plots + "\n" + data;
}

}  // namespace

DetectionErrorTradeoff CurveOf(const std::vector<SequenceOutcome>& sequences) {
  std::vector<FrameOutcome> frames;
  for (const SequenceOutcome& sequence : sequences)
    frames.insert(frames.end(), sequence.frames.begin(), sequence.frames.end());
  return ComputeTradeoff(frames);
}

nlohmann::json FiguresJson(const DetectionErrorTradeoff& curve, double min_probability) {
  const OperatingPoint chosen = curve.AtThreshold(min_probability);
  return {{"frames", curve.frames},
          {"positives", curve.positives},
          {"miss_rate_at_0.01_fppf", curve.MissRateAt(0.01)},
          {"miss_rate_at_0.1_fppf", curve.MissRateAt(0.1)},
          {"log_average_miss_rate", curve.LogAverageMissRate()},
          {"at_default_threshold",
           {{"min_probability", min_probability},
            {"true_positives", chosen.true_positives},
            {"false_positives", chosen.false_positives},
            {"misses", curve.positives - chosen.true_positives},
            {"false_positives_per_frame", chosen.false_positives_per_frame},
            {"miss_rate", chosen.miss_rate}}}};
}

nlohmann::json FiguresJson(const std::vector<SequenceOutcome>& sequences, double min_probability,
                           const BootstrapConfig& bootstrap) {
  std::vector<std::vector<FrameOutcome>> outcomes;
  for (const SequenceOutcome& sequence : sequences) outcomes.push_back(sequence.frames);
  nlohmann::json figures = FiguresJson(CurveOf(sequences), min_probability);
  const auto intervals = BootstrapIntervals(
      outcomes,
      [&](std::span<const FrameOutcome> frames) {
        const DetectionErrorTradeoff curve = ComputeTradeoff(frames);
        const OperatingPoint chosen = curve.AtThreshold(min_probability);
        return std::vector<double>{curve.MissRateAt(0.01), curve.MissRateAt(0.1),
                                   curve.LogAverageMissRate(), chosen.miss_rate,
                                   chosen.false_positives_per_frame};
      },
      bootstrap);
  const auto pair = [&](int i) { return nlohmann::json{intervals[i].low, intervals[i].high}; };
  figures["intervals"] = {
      {"confidence", bootstrap.confidence},
      {"miss_rate_at_0.01_fppf", pair(0)},
      {"miss_rate_at_0.1_fppf", pair(1)},
      {"log_average_miss_rate", pair(2)},
      {"at_default_threshold", {{"miss_rate", pair(3)}, {"false_positives_per_frame", pair(4)}}}};
  return figures;
}

nlohmann::json KindsJson(const std::vector<SequenceOutcome>& sequences, double min_probability) {
  struct Tally {
    std::int64_t sequences = 0, frames = 0, false_positives = 0, flagged = 0;
  };
  std::map<std::string, Tally> tallies;
  for (const SequenceOutcome& sequence : sequences)
    for (const std::string& kind : sequence.kinds) {
      Tally& tally = tallies[kind];
      ++tally.sequences;
      tally.frames += static_cast<std::int64_t>(sequence.frames.size());
      for (const FrameOutcome& frame : sequence.frames) {
        const auto accepted = std::count_if(frame.false_scores.begin(), frame.false_scores.end(),
                                            [&](double score) { return score >= min_probability; });
        tally.false_positives += accepted;
        tally.flagged += accepted > 0;
      }
    }
  nlohmann::json kinds = nlohmann::json::object();
  for (const auto& [kind, tally] : tallies) {
    const auto share = [&](std::int64_t count) {
      return tally.frames == 0 ? 0.0
                               : static_cast<double>(count) / static_cast<double>(tally.frames);
    };
    kinds[kind] = {{"sequences", tally.sequences},
                   {"frames", tally.frames},
                   {"false_positives_per_frame", share(tally.false_positives)},
                   {"flagged_frames", share(tally.flagged)}};
  }
  return kinds;
}

nlohmann::json SequencesJson(const std::vector<SequenceOutcome>& sequences,
                             double min_probability) {
  nlohmann::json list = nlohmann::json::array();
  for (const SequenceOutcome& sequence : sequences) {
    nlohmann::json entry = FiguresJson(ComputeTradeoff(sequence.frames), min_probability);
    entry["log"] = sequence.log;
    entry["person"] = sequence.person;
    entry["room"] = sequence.room;
    entry["kinds"] = sequence.kinds;
    entry["unjudged_frames"] = sequence.unjudged_frames;
    entry["damaged_messages"] = sequence.damaged_messages;
    entry["median_milliseconds"] = sequence.median_milliseconds;
    list.push_back(std::move(entry));
  }
  return list;
}

void PlotCurves(const std::vector<NamedCurve>& curves, const std::filesystem::path& path) {
  FILE* gnuplot = popen("gnuplot", "w");
  if (!gnuplot) throw std::runtime_error("gnuplot cannot be started: apt-get install gnuplot-nox");
  const std::string script = PlotScript(curves, path);
  const bool is_written = std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
  if (pclose(gnuplot) != 0 || !is_written || !std::filesystem::exists(path))
    throw std::runtime_error(path.string() +
                             ": gnuplot failed, is it there? apt-get install gnuplot-nox");
}

}  // namespace fallen
