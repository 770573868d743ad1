#include "updating/export/report_files.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace tapfit::updating {

namespace fs = std::filesystem;

namespace {

constexpr const char* ways_to_name =
    "name it .html, or .md for Markdown with pictures beside it";

}  // namespace

std::string report_name_fault(const fs::path& report) {
  const std::string ending = report.extension().string();
  for (const char* known : {"", ".html", ".htm", ".md", ".markdown"}) {
    if (ending == known) return {};
  }
  return fmt::format("a report is HTML or Markdown, not {}", ending);
}

std::optional<fs::path> pictures_folder(const fs::path& report) {
  const fs::path ending = report.extension();
  if (ending != ".md" && ending != ".markdown") return std::nullopt;
  return report.parent_path() / (report.stem().string() + "-files");
}

std::vector<fs::path> report_files(const fs::path& report) {
  std::vector<fs::path> files{report};
  const auto pictures = pictures_folder(report);
  if (!pictures) return files;
  std::error_code fault;
  for (fs::directory_iterator at(*pictures, fault), end; !fault && at != end;
       at.increment(fault)) {
    if (at->is_regular_file(fault)) files.push_back(at->path());
  }
  std::sort(files.begin() + 1, files.end());
  return files;
}

fs::path free_report(const acquisition::OutputRule& rule,
                     const fs::path& report) {
  return rule.free_name(report, [](const fs::path& name) {
    const auto pictures = pictures_folder(name);
    std::error_code fault;
    return !pictures || !fs::exists(fs::symlink_status(*pictures, fault));
  });
}

void check_report(const acquisition::OutputRule& rule, const fs::path& report) {
  const std::string fault = report_name_fault(report);
  if (!fault.empty()) throw InputError(fault, report.string(), ways_to_name);
  const std::string instead =
      fmt::format("give another name, such as {}",
                  free_report(rule, report).filename().string());
  for (const fs::path& file : report_files(report)) rule.check(file, instead);
}

}  // namespace tapfit::updating
