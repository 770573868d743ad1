#include "tui/commands/quality_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "signal/checks/calibration_findings.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/text_table.hpp"
#include "tui/views/frf_checks_view.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;
using signal::DrivingPoint;
using signal::FrfSet;
using signal::LowLine;
using signal::QualityFinding;
using signal::Reciprocal;
using signal::RunCoherence;

/// All that is found, before it is printed one way or the other.
struct Quality {
  std::vector<RunCoherence> runs;               ///< none for ready FRFs
  std::vector<std::vector<std::size_t>> apart;  ///< hits, per run
  const FrfSet& frfs;
  std::vector<DrivingPoint> points;
  std::vector<Reciprocal> pairs;
  std::vector<QualityFinding> findings;
};

void take(std::vector<QualityFinding> more,
          std::vector<QualityFinding>& findings) {
  std::move(more.begin(), more.end(), std::back_inserter(findings));
}

void look_at_hits(updating::Session& session,
                  const Progress& progress,
                  Quality& found) {
  const acquisition::TestBundle& bundle = session.bundle();
  found.runs.resize(bundle.runs.size());
  found.apart.resize(bundle.runs.size());
  for (const acquisition::RunGroup& group : acquisition::runs_alike(bundle)) {
    progress("coherence of hits",
             static_cast<double>(group.front()) /
                 static_cast<double>(bundle.runs.size()));
    const signal::HitCoherence of = signal::group_coherence(
        bundle, session.recordings(), session.hits(), group);
    for (const std::size_t r : group) found.runs[r] = part_of(of, bundle, r);
    for (const auto& [run, hit] : hits_apart(of)) {
      found.apart[run].push_back(hit);
    }
    take(coherence_findings(bundle, of, group), found.findings);
  }
}

// @param mass_kg of a free body; 0: not known
Quality look(updating::Session& session,
             double mass_kg,
             const Progress& progress) {
  const acquisition::TestBundle& bundle = session.bundle();
  Quality found{{},
                {},
                session.frfs(progress),
                signal::driving_points(session.frfs()),
                signal::reciprocals(session.frfs()),
                {}};
  if (!bundle.frfs) look_at_hits(session, progress, found);
  take(driving_point_findings(bundle, found.frfs, found.points),
       found.findings);
  take(reciprocity_findings(bundle, found.frfs, found.pairs), found.findings);
  if (mass_kg > 0.0) {
    take(mass_line_findings(bundle, found.frfs, found.points, mass_kg),
         found.findings);
  }
  take(signal::spread_findings(found.frfs), found.findings);
  return found;
}

std::string channel_name(const acquisition::TestBundle& bundle,
                         std::size_t run,
                         Eigen::Index sensor) {
  return bundle.channels
      .at(bundle.runs.at(run)
              .sensors.at(static_cast<std::size_t>(sensor))
              .channel)
      .name;
}

ordered_json run_json(const acquisition::TestBundle& bundle,
                      const Quality& q,
                      std::size_t run) {
  const RunCoherence& c = q.runs[run];
  ordered_json sensors = ordered_json::array();
  for (Eigen::Index s = 0; s < c.with_others.rows(); ++s) {
    std::vector<double> values(c.with_others.row(s).begin(),
                               c.with_others.row(s).end());
    sensors.push_back(
        {{"channel", channel_name(bundle, run, s)}, {"coherence", values}});
  }
  std::vector<std::size_t> hits;
  for (const std::size_t hit : c.hits) hits.push_back(hit + 1);
  std::vector<std::size_t> apart;
  for (const std::size_t hit : q.apart[run]) apart.push_back(hit + 1);
  return {{"file", bundle.runs[run].file.filename().string()},
          {"hits", hits},
          {"sensors", std::move(sensors)},
          {"apart", apart}};
}

ordered_json json_of(const std::vector<QualityFinding>& findings) {
  ordered_json list = ordered_json::array();
  for (const QualityFinding& f : findings) {
    list.push_back({{"what", f.what}, {"remedy", f.remedy}});
  }
  return list;
}

std::string text_of(const std::vector<QualityFinding>& findings) {
  if (findings.empty()) return "No check found a fault\n";
  std::string text = "Found\n";
  for (const QualityFinding& f : findings) {
    text += "  " + f.what + "\n    " + f.remedy + "\n";
  }
  return text;
}

ordered_json json_of(const acquisition::TestBundle& bundle, const Quality& q) {
  ordered_json result;
  result["runs"] = ordered_json::array();
  for (std::size_t r = 0; r < q.runs.size(); ++r) {
    result["runs"].push_back(run_json(bundle, q, r));
  }
  result["driving_points"] = ordered_json::array();
  for (const DrivingPoint& p : q.points) {
    ordered_json entry = {{"frf", name(q.frfs.frfs[p.frf])},
                          {"run", q.frfs.frfs[p.frf].run + 1},
                          {"peaks", p.peaks},
                          {"wrong_peaks", p.wrong_peaks},
                          {"active_share", p.active_share},
                          {"verdict", verdict(p)}};
    if (p.low == LowLine::Mass) entry["mass_kg"] = p.mass_kg;
    if (p.low == LowLine::Stiffness) {
      entry["stiffness_n_per_m"] = p.stiffness_n_per_m;
    }
    result["driving_points"].push_back(std::move(entry));
  }
  result["reciprocity"] = ordered_json::array();
  for (const Reciprocal& p : q.pairs) {
    result["reciprocity"].push_back({{"frf", name(q.frfs.frfs[p.frf])},
                                     {"other", name(q.frfs.frfs[p.other])},
                                     {"difference", p.difference},
                                     {"gain", p.gain},
                                     {"shape_difference", p.shape_difference},
                                     {"chi2", p.chi2}});
  }
  result["h2_over_h1_at_peaks"] = ordered_json::array();
  for (const signal::Frf& frf : q.frfs.frfs) {
    if (const auto spread = signal::spread_at_peaks(frf)) {
      result["h2_over_h1_at_peaks"].push_back(
          {{"frf", name(frf)}, {"run", frf.run + 1}, {"spread", *spread}});
    }
  }
  result["findings"] = json_of(q.findings);
  return result;
}

std::string hits_text_of(const acquisition::TestBundle& bundle,
                         const Quality& q) {
  std::string text =
      "Coherence of each hit with the others (row: sensor, column: hit)\n";
  for (std::size_t r = 0; r < q.runs.size(); ++r) {
    const RunCoherence& c = q.runs[r];
    text += "  " + bundle.runs[r].file.filename().string();
    if (c.hits.empty()) {
      text += ": no accepted hit with others at the same points\n";
      continue;
    }
    for (const std::size_t hit : c.hits) text += fmt::format(" {:>6}", hit + 1);
    text += "\n";
    for (Eigen::Index s = 0; s < c.with_others.rows(); ++s) {
      text += fmt::format("    {:<10}", channel_name(bundle, r, s));
      for (const double value : c.with_others.row(s)) {
        text += fmt::format(" {:6.4f}", value);
      }
      text += "\n";
    }
  }
  return text;
}

std::string frf_checks_text(const Quality& q) {
  TextTable points({"<driving point",
                    "run",
                    "peaks",
                    "inverted",
                    "active",
                    "<lowest lines",
                    "<verdict"});
  for (const DrivingPoint& p : q.points) {
    points.add({name(q.frfs.frfs[p.frf]),
                fmt::format("{}", q.frfs.frfs[p.frf].run + 1),
                fmt::format("{}", p.peaks),
                fmt::format("{}", p.wrong_peaks),
                percent(p.active_share),
                low_line(p),
                verdict(p)});
  }
  TextTable pairs({"<measured both ways",
                   "<other",
                   "difference",
                   "gain",
                   "beside gain",
                   "chi2"});
  for (const Reciprocal& p : q.pairs) {
    pairs.add({name(q.frfs.frfs[p.frf]),
               name(q.frfs.frfs[p.other]),
               percent(p.difference),
               fmt::format("{:.4f}", p.gain),
               percent(p.shape_difference),
               fmt::format("{:.3g}", p.chi2)});
  }
  TextTable spreads({"<FRF", "run", "H2/H1 - 1 at peaks"});
  for (const signal::Frf& frf : q.frfs.frfs) {
    if (const auto spread = signal::spread_at_peaks(frf)) {
      spreads.add(
          {name(frf), fmt::format("{}", frf.run + 1), percent(*spread)});
    }
  }
  return (q.points.empty() ? "No driving point was measured\n"
                           : points.text()) +
         (q.pairs.empty() ? "No pair was measured both ways\n" : pairs.text()) +
         spreads.text();
}

}  // namespace

std::string quality_command(const CommandOptions& options,
                            const Progress& progress) {
  updating::Session session = open_bundle(options.input);
  const Quality found = look(session, options.mass_kg, progress);
  if (options.json) return json_of(session.bundle(), found).dump(2) + "\n";
  return (found.runs.empty() ? "" : hits_text_of(session.bundle(), found)) +
         frf_checks_text(found) + text_of(found.findings);
}

std::string calibrate_command(const CommandOptions& options,
                              const Progress& progress) {
  updating::Session session = open_bundle(options.input);
  const FrfSet& frfs = session.frfs(progress);
  const auto found = signal::calibrate(frfs, options.mass_kg);
  const auto findings =
      signal::calibration_findings(session.bundle(), frfs, found);
  ordered_json list = ordered_json::array();
  TextTable table({"<FRF", "run", "gain", "sd", "delay s", "sd", "deviation"});
  for (const signal::Calibration& c : found) {
    const signal::Frf& frf = frfs.frfs[c.frf];
    list.push_back({{"frf", name(frf)},
                    {"run", frf.run + 1},
                    {"gain", {{"value", c.gain}, {"sd", c.gain_sd}}},
                    {"delay_s", {{"value", c.delay_s}, {"sd", c.delay_sd}}},
                    {"deviation", c.deviation}});
    table.add({name(frf),
               fmt::format("{}", frf.run + 1),
               fmt::format("{:.5f}", c.gain),
               fmt::format("{:.2g}", c.gain_sd),
               fmt::format("{:.3g}", c.delay_s),
               fmt::format("{:.2g}", c.delay_sd),
               percent(c.deviation)});
  }
  if (options.json) {
    return ordered_json{{"calibration", list}, {"findings", json_of(findings)}}
               .dump(2) +
           "\n";
  }
  return fmt::format("Accelerance times {:g} kg, which is 1 for a fair chain\n",
                     options.mass_kg) +
         table.text() +
         "  gain: the sensor's over the hammer's sensitivity, true over "
         "assumed; below zero: polarity inverted\n  deviation: how little the "
         "body answers as a mass alone\n" +
         text_of(findings);
}

}  // namespace tapfit::tui
