#include "tui/report/hits_text.hpp"

#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

std::vector<std::string> reasons(const acquisition::Hit& hit) {
  std::vector<std::string> names;
  for (const auto fault : hit.reasons) names.push_back(name(fault));
  return names;
}

ordered_json second_json(const acquisition::SecondPulse& second) {
  return {{"percent", 100.0 * second.share},
          {"after_s", second.after_s},
          {"force_loss_db", second.loss_db},
          {"response_outside_percent", 100.0 * second.outside}};
}

long accepted(const std::vector<acquisition::Hit>& hits) {
  return std::count_if(
      hits.begin(), hits.end(), [](const auto& hit) { return hit.accepted; });
}

std::string strongest(const std::vector<acquisition::Hit>& hits) {
  double peak = 0.0;
  for (const auto& hit : hits) peak = std::max(peak, hit.peak_n);
  return fmt::format("{:.1f}", peak);
}

std::string sensors_text(const acquisition::TestBundle& bundle,
                         const acquisition::Run& run) {
  std::string text;
  for (const auto& sensor : run.sensors) {
    if (!text.empty()) text += ", ";
    text += fmt::format(
        "{} ({})", name(sensor.dof), bundle.channels.at(sensor.channel).name);
  }
  return text;
}

std::string rejected_text(const acquisition::TestBundle& bundle,
                          const acquisition::HitSet& hits) {
  TextTable table({"<rejected", "time s", "peak N", "<reason"});
  long count = 0;
  for (std::size_t run = 0; run < hits.runs.size(); ++run) {
    for (const auto& hit : hits.runs[run]) {
      if (hit.accepted) continue;
      table.add({bundle.runs.at(run).file.filename().string(),
                 fmt::format("{:.3f}", hit.time_s),
                 fmt::format("{:.1f}", hit.peak_n),
                 fmt::format("{}", fmt::join(reasons(hit), ", "))});
      ++count;
    }
  }
  return count > 0 ? table.text() : "  none rejected\n";
}

}  // namespace

ordered_json hits_json(const acquisition::TestBundle& bundle,
                       const acquisition::HitSet& hits) {
  ordered_json runs = ordered_json::array();
  for (std::size_t run = 0; run < hits.runs.size(); ++run) {
    ordered_json list = ordered_json::array();
    for (const auto& hit : hits.runs[run]) {
      ordered_json entry = {{"time_s", hit.time_s},
                            {"peak_n", hit.peak_n},
                            {"accepted", hit.accepted},
                            {"reasons", reasons(hit)}};
      if (hit.second) entry["second_blow"] = second_json(*hit.second);
      list.push_back(std::move(entry));
    }
    runs.push_back({{"file", bundle.runs.at(run).file.filename().string()},
                    {"hits", std::move(list)}});
  }
  return {{"runs", std::move(runs)}, {"statements", hits.statements}};
}

std::string hits_text(const acquisition::TestBundle& bundle,
                      const acquisition::HitSet& hits) {
  std::size_t found = 0;
  long good = 0;
  TextTable table(
      {"<run", "hits", "accepted", "peak N", "<hit at", "<sensors"});
  for (std::size_t index = 0; index < hits.runs.size(); ++index) {
    const auto& list = hits.runs[index];
    const auto& run = bundle.runs.at(index);
    found += list.size();
    good += accepted(list);
    table.add({run.file.filename().string(),
               fmt::format("{}", list.size()),
               fmt::format("{}", accepted(list)),
               strongest(list),
               name(run.hammer.dof),
               sensors_text(bundle, run)});
  }
  std::string text = fmt::format("Hits: {} found, {} accepted\n", found, good);
  text += table.text() + rejected_text(bundle, hits);
  for (const auto& statement : hits.statements) text += "  " + statement + "\n";
  return text;
}

}  // namespace tapfit::tui
