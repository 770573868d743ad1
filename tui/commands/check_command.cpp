#include "acquisition/foundation/input_error.hpp"
#include "signal/checks/frf_quality.hpp"
#include "tui/commands/commands.hpp"
#include "tui/report/finding_text.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/point_places.hpp"
#include "tui/report/text_table.hpp"
#include "tui/views/frf_checks_view.hpp"
#include "updating/session/session.hpp"
#include "updating/test_check/test_check.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;
using signal::DrivingPoint;
using signal::FrfSet;
using signal::LowLine;
using signal::Reciprocal;
using signal::RunCoherence;

using updating::TestCheck;

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
                      const TestCheck& q,
                      std::size_t run) {
  const RunCoherence& c = q.coherence[run];
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

/// A channel's records over all runs: extremes, and means of what has none.
struct ChannelSummary {
  std::size_t channel = 0;
  double range_used = 0.0;     ///< largest
  double bits = 0.0;           ///< largest
  double over_noise_db = 0.0;  ///< least level over noise; of the hammer, peak
  double drift = 0.0;          ///< largest, of the level
  int dropouts = 0;
};

std::vector<ChannelSummary> summaries(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::ChannelRecord>& records) {
  std::vector<ChannelSummary> all;
  for (std::size_t c = 0; c < bundle.channels.size(); ++c) {
    ChannelSummary sum{c};
    bool any = false;
    for (const acquisition::ChannelRecord& r : records) {
      if (r.channel != c) continue;
      const bool hammer = bundle.runs[r.run].hammer.channel == c;
      const double level = hammer ? r.peak : r.level;
      const double db = r.noise > 0.0 && level > 0.0
                            ? 20.0 * std::log10(level / r.noise)
                            : 0.0;
      sum.over_noise_db = any ? std::min(sum.over_noise_db, db) : db;
      sum.range_used = std::max(sum.range_used, r.range_used());
      sum.bits = std::max(sum.bits, r.bits());
      sum.drift = std::max(sum.drift, r.level > 0.0 ? r.drift / r.level : 0.0);
      sum.dropouts += r.dropouts;
      any = true;
    }
    if (any) all.push_back(sum);
  }
  return all;
}

std::string channels_text(const acquisition::TestBundle& bundle,
                          const TestCheck& q) {
  TextTable table(
      {"<channel", "range used", "bits", "over noise dB", "drift", "dropouts"});
  for (const ChannelSummary& c : summaries(bundle, q.records)) {
    table.add({bundle.channels[c.channel].name,
               percent(c.range_used),
               fmt::format("{:.1f}", c.bits),
               fmt::format("{:.0f}", c.over_noise_db),
               percent(c.drift),
               fmt::format("{}", c.dropouts)});
  }
  return table.text();
}

ordered_json channels_json(const acquisition::TestBundle& bundle,
                           const TestCheck& q) {
  ordered_json list = ordered_json::array();
  for (const ChannelSummary& c : summaries(bundle, q.records)) {
    list.push_back({{"channel", bundle.channels[c.channel].name},
                    {"range_used", c.range_used},
                    {"bits", c.bits},
                    {"over_noise_db", c.over_noise_db},
                    {"drift", c.drift},
                    {"dropouts", c.dropouts}});
  }
  return list;
}

ordered_json json_of(const acquisition::TestBundle& bundle,
                     const FrfSet& frfs,
                     const TestCheck& q) {
  ordered_json result;
  result["runs"] = ordered_json::array();
  for (std::size_t r = 0; r < q.coherence.size(); ++r) {
    result["runs"].push_back(run_json(bundle, q, r));
  }
  result["driving_points"] = ordered_json::array();
  for (const DrivingPoint& p : q.points) {
    ordered_json entry = {{"frf", name(frfs.frfs[p.frf])},
                          {"run", frfs.frfs[p.frf].run + 1},
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
    result["reciprocity"].push_back({{"frf", name(frfs.frfs[p.frf])},
                                     {"other", name(frfs.frfs[p.other])},
                                     {"difference", p.difference},
                                     {"gain", p.gain},
                                     {"shape_difference", p.shape_difference},
                                     {"chi2", p.chi2}});
  }
  result["h2_over_h1_at_peaks"] = ordered_json::array();
  for (const signal::Frf& frf : frfs.frfs) {
    if (const auto spread = signal::spread_at_peaks(frf)) {
      result["h2_over_h1_at_peaks"].push_back(
          {{"frf", name(frf)}, {"run", frf.run + 1}, {"spread", *spread}});
    }
  }
  result["channels"] = channels_json(bundle, q);
  result["findings"] = findings_json(bundle, q.findings);
  return result;
}

std::string hits_text_of(const acquisition::TestBundle& bundle,
                         const TestCheck& q) {
  std::string text =
      "Coherence of each hit with the others (row: sensor, column: hit)\n";
  for (std::size_t r = 0; r < q.coherence.size(); ++r) {
    const RunCoherence& c = q.coherence[r];
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

std::string frf_checks_text(const FrfSet& frfs, const TestCheck& q) {
  TextTable points({"<driving point",
                    "run",
                    "peaks",
                    "turned",
                    "active",
                    "<lowest lines",
                    "<verdict"});
  for (const DrivingPoint& p : q.points) {
    points.add({name(frfs.frfs[p.frf]),
                fmt::format("{}", frfs.frfs[p.frf].run + 1),
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
    pairs.add({name(frfs.frfs[p.frf]),
               name(frfs.frfs[p.other]),
               percent(p.difference),
               fmt::format("{:.4f}", p.gain),
               percent(p.shape_difference),
               fmt::format("{:.3g}", p.chi2)});
  }
  TextTable spreads({"<FRF", "run", "H2/H1 - 1 at peaks"});
  for (const signal::Frf& frf : frfs.frfs) {
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

// None where the check did not come as far.
FrfSet frfs_of(updating::Session& session, const Progress& progress) {
  try {
    return session.frfs(progress);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

std::string check_command(const CommandOptions& options,
                          const Progress& progress) {
  updating::Session session(options.input, acquisition::Unreadable::LeftOut);
  const std::optional<double> body_kg =
      options.mass_kg > 0.0 ? std::optional(options.mass_kg) : std::nullopt;
  const TestCheck found = check_test(session, body_kg, progress);
  const acquisition::TestBundle& bundle = session.bundle();
  const FrfSet frfs = frfs_of(session, progress);
  if (options.json) {
    ordered_json json = json_of(bundle, frfs, found);
    if (found.placed > 0) add_point_places(session.deck(progress), json);
    return json_text(json);
  }
  std::string text = findings_text(found.findings);
  if (!found.records.empty()) text += channels_text(bundle, found);
  if (!found.coherence.empty()) text += hits_text_of(bundle, found);
  if (!frfs.frfs.empty()) text += frf_checks_text(frfs, found);
  if (found.placed > 0) text += point_places_text(session.deck(progress));
  return text;
}

}  // namespace tapfit::tui
