#include "tui/widgets/finding_list.hpp"

#include "tui/screen/layout.hpp"
#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tapfit::tui {
namespace {

Colour colour_of(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return Colour::Red;
    case Severity::Warning:
      return Colour::Yellow;
    case Severity::Note:
      return Colour::Grey;
  }
  return Colour::Default;
}

// Wrapped, indented by `x`; returns the next free row.
int write(Screen& screen,
          const Rect& rect,
          int y,
          int x,
          const std::string& text,
          const Style& style) {
  for (const std::string& line : wrapped(text, rect.width - x - 1)) {
    if (y >= rect.y + rect.height) return y;
    screen.text(rect.x + x, y++, line, style, rect.width - x);
  }
  return y;
}

std::string summary(const std::vector<Finding>& findings) {
  const auto count = [&findings](Severity severity) {
    return std::ranges::count(findings, severity, &Finding::severity);
  };
  return fmt::format(
      "{} errors, {} warnings, {} notes{}",
      count(Severity::Error),
      count(Severity::Warning),
      count(Severity::Note),
      count(Severity::Error) > 0
          ? "; a diagnosis means nothing until the errors are set right"
          : "");
}

}  // namespace

void draw_findings(Screen& screen,
                   const Rect& rect,
                   const std::vector<Finding>* findings,
                   std::size_t first) {
  if (findings == nullptr) {
    write(screen, rect, rect.y, 1, "The checks are being worked out.", {});
    return;
  }
  if (findings->empty()) {
    write(screen, rect, rect.y, 1, "No check found a fault.", {});
    return;
  }
  int y = write(
      screen, rect, rect.y, 1, summary(*findings), {.colour = Colour::Grey});
  for (std::size_t i = std::min(first, findings->size() - 1);
       i < findings->size();
       ++i) {
    const Finding& finding = (*findings)[i];
    const std::string where = describe(finding.where);
    y = write(screen,
              rect,
              y,
              1,
              fmt::format("{}  {}{}{}",
                          name(finding.severity),
                          where,
                          where.empty() ? "" : ": ",
                          finding.what),
              {.colour = colour_of(finding.severity)});
    if (!finding.likely.empty()) {
      y = write(screen, rect, y, 3, "likely: " + finding.likely, {});
    }
    if (!finding.remedy.empty()) {
      y = write(screen, rect, y, 3, "to do: " + finding.remedy, {});
    }
  }
}

}  // namespace tapfit::tui
