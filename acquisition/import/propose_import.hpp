// What a recording of hammer and sensors is likely to be, where nothing but
// its file is named: which channel is the hammer, units, sensitivities, points.
//
// Whatever the file does not say itself is an assumption, and named as such
// with the way to correct it.
#pragma once

#include "acquisition/import/import_recordings.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

/// One thing that was assumed.
struct ImportAssumption {
  std::string what;    ///< a sentence without a full stop
  std::string option;  ///< of the command line that says otherwise
  std::string field;   ///< of test.json that can be changed instead; or empty
};

struct ImportProposal {
  ImportOptions options;           ///< complete
  std::vector<std::string> found;  ///< what the file says, a line each
  std::vector<ImportAssumption> assumptions;
};

/// Completes what the options leave open (a hammer without a column, no
/// sensors) by the first of the files.
///
///   - The hammer is as choose_hammer() says.
///   - All other channels in a unit of motion, or without any unit, are
///     sensors; so are channels in volts where there are no others.
///   - Channels whose names differ in X, Y, Z at their end are at one point.
///     Points without a number get one of their own each.
///
/// @throws InputError for what cannot be read, where no sensor is left, for a
///   universal file of several hammers, which is a bundle by itself; Stopped
[[nodiscard]] ImportProposal propose_import(const ImportOptions& given,
                                            const Progress& progress = {});

}  // namespace tapfit::acquisition
