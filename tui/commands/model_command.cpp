#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "tui/commands/commands.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/text_table.hpp"
#include "updating/measurement/test_model.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/checks/unit_checks.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/readers/scale_units.hpp"
#include "updating/structure/solve/system.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;

struct ModelSummary {
  std::size_t grids = 0;
  std::size_t elements = 0;
  std::size_t dofs = 0;  // free ones
  double mass_kg = 0.0;
  Eigen::VectorXd frequency_hz;
  std::vector<std::string> warnings;
};

// The model of a bundle, or a deck by itself.
structure::Deck read_any_model(const CommandOptions& options) {
  const std::filesystem::path& input = options.input;
  if (!std::filesystem::is_directory(input)) {
    structure::Deck deck = structure::read_deck(input, options.ignored_cards);
    structure::scale_to_si(deck, options.units);
    for (std::string& text : structure::unit_warnings(deck)) {
      deck.warnings.push_back(std::move(text));
    }
    return deck;
  }
  acquisition::TestBundle bundle = acquisition::read_test_bundle(input);
  bundle.ignored_cards.insert(bundle.ignored_cards.end(),
                              options.ignored_cards.begin(),
                              options.ignored_cards.end());
  if (!options.units.empty()) bundle.units = options.units;
  return updating::read_test_model(bundle);
}

ModelSummary summarise(const structure::Deck& deck,
                       int count,
                       const std::stop_token& stop) {
  const structure::System system = structure::assemble(deck);
  const structure::DeckModes solved =
      structure::deck_modes(deck, system, count, stop);
  ModelSummary summary{.grids = deck.grids.size() - deck.measuring.size(),
                       .elements = deck.element_count(),
                       .dofs = system.free_dofs().size(),
                       .mass_kg = structure::total_mass(deck, system),
                       .frequency_hz = solved.modes.frequency_hz,
                       .warnings = deck.warnings};
  summary.warnings.insert(
      summary.warnings.end(), solved.warnings.begin(), solved.warnings.end());
  return summary;
}

ordered_json model_json(const ModelSummary& summary) {
  return {{"grids", summary.grids},
          {"elements", summary.elements},
          {"dofs", summary.dofs},
          {"mass_kg", summary.mass_kg},
          {"frequencies_hz",
           std::vector<double>(summary.frequency_hz.begin(),
                               summary.frequency_hz.end())},
          {"warnings", summary.warnings}};
}

std::string model_text(const ModelSummary& summary) {
  std::string text = fmt::format(
      "Model: {} grids, {} elements, {} free degrees of freedom, {:.4g} kg\n",
      summary.grids,
      summary.elements,
      summary.dofs,
      summary.mass_kg);
  TextTable table({"mode", "frequency Hz"});
  for (Eigen::Index mode = 0; mode < summary.frequency_hz.size(); ++mode) {
    table.add({fmt::format("{}", mode + 1),
               fmt::format("{:.4f}", summary.frequency_hz(mode))});
  }
  text += table.text();
  for (const auto& warning : summary.warnings) {
    text += "  note: " + warning + "\n";
  }
  return text;
}

}  // namespace

std::string model_command(const CommandOptions& options,
                          const Progress& progress) {
  progress("reading the model", 0.0);
  const structure::Deck deck = read_any_model(options);
  progress("solving for modes", 0.3);
  const ModelSummary summary = summarise(deck, options.modes, progress.stop);
  return options.json ? json_text(model_json(summary)) : model_text(summary);
}

}  // namespace tapfit::tui
