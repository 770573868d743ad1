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
      .add_option("--nodes",
                  options.node_dataset,
                  "Dataset of the model's grids in universal files: 2411 "
                  "(default), or 15 for older programs")
      ->check(CLI::IsMember({15, 2411}));
}

void check_has_export(const CommandOptions& options) {
  if (options.uff || options.deck || options.records || options.vtu) return;
  throw CLI::RequiredError(
      "a file to write (--uff, --records, --deck, --vtu or several)");
}

}  // namespace tapfit::tui
