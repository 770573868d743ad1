// The plots of the screen for others: written as pictures and tables under
// names that are free, copied as numbers.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "tui/app/program.hpp"
#include "tui/document/drawing_text.hpp"
#include "tui/screen/clipboard.hpp"
#include "updating/export/output_rule_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

/// "run.v2" keeps its point.
fs::path with_ending(fs::path named, const std::string& ending) {
  const fs::path own = named.extension();
  if (own == ".svg" || own == ".csv") named.replace_extension();
  return named += ending;
}

/// As named, or with a number behind it, so that none of the files is there.
fs::path free_for(const fs::path& named,
                  const std::vector<PlotFile>& files,
                  const acquisition::OutputRule& rule) {
  return rule.free_name(named, [&](const fs::path& name) {
    return std::ranges::none_of(files, [&](const PlotFile& file) {
      const fs::path path = with_ending(name, file.ending);
      std::error_code fault;
      return fs::exists(fs::symlink_status(path, fault)) || rule.is_input(path);
    });
  });
}

std::vector<acquisition::FileContent> named_files(
    const fs::path& named, const std::vector<PlotFile>& files) {
  std::vector<acquisition::FileContent> all;
  for (const PlotFile& file : files) {
    all.push_back({with_ending(named, file.ending), file.content});
  }
  return all;
}

std::string lower(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

}  // namespace

std::vector<Drawing> Program::plotted() const {
  Drawings drawings;
  if (ready(page())) {
    Canvas canvas = focused_canvas();
    canvas.drawings = &drawings;
    canvas.pixels = {};
    (void)page().draw(known_, canvas);
  }
  return std::move(drawings.shown);
}

std::string Program::why_no_plot() const {
  if (lacks_input(page()))
    return "nothing is plotted here: the test has no such data";
  if (!known_.bundle) return "nothing is plotted yet: the bundle is opened";
  const auto missing = [this](const std::vector<Need>& needs) {
    return std::ranges::find_if(
        needs, [this](const Need& need) { return !known_.has(need); });
  };
  std::vector<Need> needs = page().essential();
  if (missing(needs) == needs.end()) needs = page().welcome(known_);
  const auto need = missing(needs);
  if (need == needs.end()) return "nothing is plotted here";
  const auto failed = failed_.find(*need);
  return failed == failed_.end()
             ? "nothing is plotted yet: still working out " + name(need->stage)
             : fmt::format(
                   "no plot without {}: {}", name(need->stage), failed->second);
}

void Program::write_plots(const std::string& named) {
  const std::vector<PlotFile> files = plot_files(plotted());
  if (files.empty()) return tell(why_no_plot());
  const fs::path wanted =
      named.empty()
          ? known_.bundle->folder / (lower(page().title()) + "-plot.svg")
          : with_ending(named, ".svg");
  try {
    const acquisition::OutputRule rule =
        updating::output_rule_of(*known_.bundle, false, {wanted});
    const fs::path free = free_for(wanted, files, rule);
    acquisition::write_files(named_files(free, files), rule);
    tell(fmt::format("written: {}{}{}",
                     with_ending(free, files.front().ending).string(),
                     files.size() > 2   ? " … "
                     : files.size() > 1 ? " and "
                                        : "",
                     files.size() > 1 ? files.back().ending : ""));
  } catch (const InputError& error) {
    tell(error.what(), true);
  }
}

void Program::copy_plots() {
  std::string text;
  const std::vector<Drawing> drawings = plotted();
  if (drawings.empty()) return tell(why_no_plot());
  for (const Drawing& drawing : drawings) {
    const std::string table = drawing_table(drawing, '\t');
    text += (text.empty() || table.empty() ? "" : "\n") + table;
  }
  if (text.empty()) return tell("no numbers are plotted here");
  if (!copy_) return tell("y copies in a terminal; P writes the plot");
  if (text.size() > most_copied) {
    return tell("too much for the clipboard: zoom in, or P writes the plot");
  }
  copy_(text);
  tell(fmt::format("copied {} lines with tabs between the columns",
                   std::ranges::count(text, '\n')));
}

}  // namespace tapfit::tui
