#include "tui/options/option_groups.hpp"

namespace tapfit::tui {

void add_import_options(CLI::App& command, CommandOptions& options) {
  ImportArguments& given = options.imports;
  command.add_option("FILE", given.files, "FILE, or FILE@POINT of its blows")
      ->required();
  command
      .add_option("-o,--output",
                  options.output,
                  "Folder of the bundle (called after FILE)")
      ->type_name("FOLDER");
  command.add_option("--hammer",
                     given.hammer,
                     "COLUMN@POINT,KEY=VALUE...; without it the one with the "
                     "unit of a force or the shortest pulses");
  command
      .add_option("--sensor",
                  given.sensors,
                  "COLUMN@POINT,KEY=VALUE...; without it all other channels")
      ->allow_extra_args(false);
  command.add_option("--rate",
                     given.rate,
                     "Samples per second, or a variable of the file that says "
                     "it");
  command.add_option("--time", given.time_column, "Column of the time [s]");
  command.add_option("--title", given.title, "Title of the bundle");
  command.add_option("--deck", options.deck, "Its bulk data model")
      ->type_name("FILE");
  command
      .add_option("--band", given.band_hz, "Lowest and highest frequency [Hz]")
      ->type_name("LOW HIGH")
      ->delimiter(',');
  command.add_flag("--force",
                   options.force,
                   "Replace files that are there; never what the test reads");
  command.add_flag("--json", options.json, "Print one JSON object");
}

}  // namespace tapfit::tui
