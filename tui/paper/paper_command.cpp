#include "tui/paper/paper_command.hpp"

#include "signal/files/uff58.hpp"
#include "tui/paper/paper_structures.hpp"
#include "updating/studies/truss_study.hpp"
#include "updating/studies/wing_study.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

struct Structure {
  const char* name;
  const char* folder;
  PaperReport (*work)(const fs::path& folder, const Progress& progress);
};

constexpr std::array<Structure, 3> structures{{
    {"truss", "paper-truss", paper_truss},
    {"wing", "paper-solar-wing", paper_wing},
    {"frame", "solar-panel-frame", paper_frame},
}};

// The simulated FRFs that the bundles hold.
std::string write_measured(const fs::path& recordings) {
  const fs::path truss = recordings / structures[0].folder;
  const fs::path wing = recordings / structures[1].folder;
  const updating::TrussStudy of_truss(truss);
  const updating::WingStudy of_wing(wing);
  signal::write_frfs_uff(of_truss.measured(1),
                         of_truss.study().bundle().title,
                         truss / "measured.uff");
  signal::write_frfs_uff(of_wing.measured(1),
                         of_wing.study().bundle().title,
                         wing / "measured.uff");
  return "written: " + (truss / "measured.uff").string() +
         "\nwritten: " + (wing / "measured.uff").string() + "\n";
}

}  // namespace

std::string paper_command(const CommandOptions& options,
                          const Progress& progress) {
  if (options.paper.write) return write_measured(options.input);
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  std::string text;
  for (const Structure& structure : structures) {
    const auto& named = options.paper.structures;
    const bool wanted = named.empty() ||
                        std::ranges::find(named, structure.name) != named.end();
    if (!wanted) continue;
    const PaperReport report =
        structure.work(options.input / structure.folder, progress);
    all.push_back(paper_json(report));
    text += (text.empty() ? "" : "\n") + paper_text(report);
  }
  return options.json
             ? nlohmann::ordered_json{{"structures", all}}.dump(2) + "\n"
             : text;
}

}  // namespace tapfit::tui
