#include "tui/options/option_groups.hpp"

namespace tapfit::tui {

void add_export_options(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--deck,--bdf",
                  options.deck,
                  "Updated deck to write (.inp for one of Abaqus or "
                  "CalculiX)")
      ->type_name("FILE");
  auto* records = command.add_option(
      "--records", options.records, "Universal file of the time records");
  records->type_name("FILE");
  command
      .add_flag("--text",
                options.text_records,
                "Time records as text, not binary (58b)")
      ->needs(records);
  command
      .add_option("--vtu",
                  options.vtu,
                  "Mode shapes and error map for ParaView: NAME.pvd with two "
                  ".vtu beside it")
      ->type_name("NAME.pvd");
  command
      .add_option("--plots",
                  options.plots,
                  "What the screens plot, as SVG and CSV; with a model it is "
                  "diagnosed for that")
      ->type_name("FOLDER");
  command
      .add_option("--tables",
                  options.tables,
                  "The tables that --csv prints of hits, frf, modes, compare "
                  "and diagnose (with --effect: update)")
      ->type_name("FOLDER");
  command
      .add_option("--nodes",
                  options.node_dataset,
                  "Dataset of the model's grids in universal files: 2411 "
                  "(default), or 15 for older programs")
      ->check(CLI::IsMember({15, 2411}));
}

void check_has_export(const CommandOptions& options) {
  if (options.uff || options.deck || options.records || options.vtu ||
      options.plots || options.tables) {
    return;
  }
  throw CLI::RequiredError(
      "a file to write (--uff, --records, --deck, --vtu, --plots, --tables or "
      "several)");
}

}  // namespace tapfit::tui
