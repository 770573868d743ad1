#include "tui/report/finding_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;

ordered_json where_json(const acquisition::TestBundle& bundle,
                        const Subject& where) {
  ordered_json json = ordered_json::object();
  if (where.runs.size() == 1) {
    json["run"] = where.runs.front() + 1;
    if (where.runs.front() < bundle.runs.size()) {
      json["file"] = bundle.runs[where.runs.front()].file.filename().string();
    }
  }
  if (!where.runs.empty()) {
    json["runs"] = ordered_json::array();
    for (const std::size_t run : where.runs) json["runs"].push_back(run + 1);
  }
  if (!where.channel.empty()) json["channel"] = where.channel;
  if (where.hit) json["hit"] = *where.hit + 1;
  if (!where.point.empty()) json["point"] = where.point;
  return json;
}

}  // namespace

std::string findings_text(const std::vector<Finding>& findings) {
  if (findings.empty()) return "No check found a fault\n";
  std::string text = "Found\n";
  for (const Finding& finding : findings) {
    const std::string where = describe(finding.where);
    text += fmt::format("  {:<8} {}{}{}\n",
                        name(finding.severity),
                        where,
                        where.empty() ? "" : ": ",
                        finding.what);
    if (!finding.likely.empty()) text += "    likely: " + finding.likely + "\n";
    if (!finding.remedy.empty()) text += "    to do:  " + finding.remedy + "\n";
  }
  return text;
}

ordered_json findings_json(const acquisition::TestBundle& bundle,
                           const std::vector<Finding>& findings) {
  ordered_json list = ordered_json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"severity", name(finding.severity)},
                    {"what", finding.what},
                    {"where", where_json(bundle, finding.where)},
                    {"likely", finding.likely},
                    {"remedy", finding.remedy}});
  }
  return list;
}

}  // namespace tapfit::tui
