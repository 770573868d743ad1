#include "acquisition/foundation/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tapfit {
namespace {

// "4-6, 9", counted from 1.
std::string numbers(const std::vector<std::size_t>& runs) {
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::size_t last = i;
    while (last + 1 < runs.size() && runs[last + 1] == runs[last] + 1) ++last;
    if (!text.empty()) text += ", ";
    text += fmt::format("{}", runs[i] + 1);
    if (last > i) text += fmt::format("-{}", runs[last] + 1);
    i = last;
  }
  return text;
}

}  // namespace

std::string name(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "?";
}

std::string describe(const Subject& subject) {
  std::string text;
  const auto add = [&text](const std::string& part) {
    if (part.empty()) return;
    text += (text.empty() ? "" : ", ") + part;
  };
  if (!subject.runs.empty()) {
    add((subject.runs.size() == 1 ? "run " : "runs ") + numbers(subject.runs));
  }
  add(subject.channel);
  if (subject.hit) add(fmt::format("hit {}", *subject.hit + 1));
  if (!subject.point.empty()) {
    text += (text.empty() ? "at " : " at ") + subject.point;
  }
  return text;
}

std::string statement(const Finding& finding) {
  return finding.likely.empty() ? finding.what
                                : finding.what + ": " + finding.likely;
}

std::string in_full(const Finding& finding) {
  return finding.remedy.empty() ? statement(finding)
                                : statement(finding) + "; " + finding.remedy;
}

void append(std::vector<Finding> more, std::vector<Finding>& all) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

void sort_by_severity(std::vector<Finding>& findings) {
  std::ranges::stable_sort(findings, [](const Finding& a, const Finding& b) {
    return a.severity > b.severity;
  });
}

std::string in_digits(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return fmt::format("{}", value);
  const double behind = digits - 1.0 - std::floor(std::log10(std::abs(value)));
  if (std::abs(behind) > 12.0) return fmt::format("{:.{}g}", value, digits);
  if (behind <= 0.0) {
    const double step = std::pow(10.0, -behind);
    return fmt::format("{:.0f}", std::round(value / step) * step);
  }
  std::string text = fmt::format("{:.{}f}", value, static_cast<int>(behind));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace tapfit
