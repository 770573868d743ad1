// tapfit import: makes a test bundle out of files of time records.
#pragma once

#include "acquisition/import/import_recordings.hpp"
#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Reads "COLUMN@POINT[,KEY=VALUE ...]", for example
/// "2@12Z+,unit=g,name=acc1,mass_kg=0.02". Keys: name, unit, volts_per_unit,
/// mass_kg, flip.
///
/// @throws InputError naming the part that cannot be read
[[nodiscard]] acquisition::ImportChannel parse_import_channel(
    const std::string& text, acquisition::Quantity quantity);

/// Reads "FILE" or "FILE@POINT", the point where this file's blows fell.
[[nodiscard]] acquisition::ImportFile parse_import_file(
    const std::string& text);

/// Says what was assumed of the channels that the command line does not name.
/// @throws InputError
[[nodiscard]] std::string import_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
