#include "tui/options/option_groups.hpp"

namespace tapfit::tui {

void add_export_options(CLI::App& command, CommandOptions& options) {
  command.add_option("--deck,--bdf", options.deck, "Bulk data file to write");
  auto* records = command.add_option(
      "--records", options.records, "Universal file of the time records");
  command
      .add_flag("--text",
                options.text_records,
                "Time records as text, not binary (58b)")
      ->needs(records);
  command.add_option("--vtu",
                     options.vtu,
                     "Mode shapes and error map for ParaView: NAME.pvd with "
                     "two .vtu beside it");
  command
      .add_option("--nodes",
                  options.node_dataset,
                  "Dataset of the model's grids in universal files: 2411 "
                  "(default), or 15 for older programs")
      ->check(CLI::IsMember({15, 2411}));
}

}  // namespace tapfit::tui
