// The room signal/files. FRFs in universal files, read and written.
// In:  Datasets 58 and 58b.
// Out: FrfSet, or the file.
// May include: its row in CONTRIBUTING.md.
//
// FRFs in universal files: dataset 58 (functions at nodal degrees of freedom),
// type 4 (FRF), ASCII and binary (58b).
//
// Record 6   2(I5,I10),2(1X,10A1,I10,I4)  function type, who, to whom
// Record 7   3I10,3E13.5                  data type, lines, spacing
// Record 8-11  I10,3I5,2(1X,20A1)         what abscissa and ordinate are
// Record 12  data: 6E13.5 single, 4E20.12 double, real/complex, even/uneven
//
// Source: SDRC universal file format 58, revision 3, as kept by the University
// of Cincinnati (www.sdrl.uc.edu/sdrl/referenceinfo/universalfileformats).
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "signal/frf_set/convert.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::signal {

struct UffFrfs {
  FrfSet set;                        ///< accelerances
  std::vector<std::string> skipped;  ///< what was not read, and why
};

/// Reads the FRFs of a universal file.
///
/// Line ends of any system, Fortran's D exponents, lines cut short and glued
/// columns are accepted. Receptances, mobilities and FRFs of velocity or
/// displacement are made accelerances; units that dataset 164 or the axis
/// names give are made SI. Datasets of another kind, FRFs whose lines differ
/// from the first one's, and FRFs with a unit label that is not known are
/// skipped and named, FRFs among the set's statements too. An exponential
/// window's decay rate, from write_frfs_uff's ID line or a dataset 1858, comes
/// back in s; without one s = j omega. What a universal file does not hold is
/// set: coherence 1, variance 0, hits 0, channel 0; run counts the reference
/// points. Directions count along the displacement systems of their nodes (15
/// or 2411, 18 or 2420): turned into global ones where they lie along these,
/// else at points of the test's own (acquisition::turned). Coherence functions
/// (type 6) of the same degrees of freedom are taken in.
///
/// @throws InputError for a missing file, a broken record (with its line), a
///   file without any FRF, a node in a coordinate system that is not there
[[nodiscard]] UffFrfs read_frfs_uff(const std::filesystem::path& file);

/// As above, from memory.
/// @param name the source's name, for messages
[[nodiscard]] UffFrfs read_frfs_uff_text(std::string_view text,
                                         const std::string& name);

/// Writes the set with datasets 151 and 164 (SI) before the FRFs, type 4,
/// complex double precision. The exponential window's decay rate sigma, when
/// it is not 0, stands in ID line 4 of each FRF ("SIGMA = ... 1/s") and as
/// window damping factor in a dataset 1858 behind it.
///
/// @param title for the header, cut at 80 characters
/// @param form what the accelerances of the set are written as
void write_frfs_uff(const FrfSet& set,
                    const std::string& title,
                    std::ostream& out,
                    FrfForm form = FrfForm::Accelerance);

/// As above, to a file.
/// @param points with their systems, behind the FRFs: those of the test's own,
///   whose directions no grid's axes say
/// @throws InputError where the rule does not let it, or it cannot be written
void write_frfs_uff(const FrfSet& set,
                    const std::string& title,
                    const std::filesystem::path& file,
                    const acquisition::OutputRule& rule,
                    FrfForm form = FrfForm::Accelerance,
                    const acquisition::UffGeometry& points = {});

}  // namespace tapfit::signal
