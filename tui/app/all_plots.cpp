#include "tui/app/all_plots.hpp"

#include "tui/app/program.hpp"
#include "tui/app/replay.hpp"

#include <array>
#include <string>
#include <utility>

namespace tapfit::tui {

std::vector<PlotFile> all_plots(std::unique_ptr<Workbench> bench,
                                const Progress& progress) {
  constexpr std::array<const char*, 7> names{
      "recording", "frf", "modes", "compare", "diagnose", "update", "report"};
  constexpr Canvas canvas{200, 60};
  Program program(std::move(bench), canvas);
  std::vector<PlotFile> all;
  for (std::size_t k = 0; k < names.size(); ++k) {
    progress("plots", static_cast<double>(k) / names.size());
    program.press(Key(static_cast<char32_t>(U'1' + k)));
    wait_until_idle(program);
    for (PlotFile& file : plot_files(program.plotted())) {
      file.ending.insert(0, names[k]);
      all.push_back(std::move(file));
    }
  }
  return all;
}

}  // namespace tapfit::tui
