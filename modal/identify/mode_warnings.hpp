// What is said about modes that were found, and about poles left out.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "modal/poles/identify_options.hpp"
#include "modal/poles/weighted_frfs.hpp"
#include "modal/select/repeated_poles.hpp"

#include <complex>
#include <string>
#include <vector>

namespace tapfit::modal {

/// Damping lost in its uncertainty, points that do not move in phase.
void warn_about(const Mode& mode, std::vector<std::string>& warnings);

/// A resonance narrower than the lines of a block without a window.
void warn_about_resolution(const WeightedFrfs& curves,
                           const Mode& mode,
                           std::vector<std::string>& warnings);

/// Modes that leave most of the FRFs.
void warn_about_misfit(double synthesis_error,
                       std::vector<std::string>& warnings);

/// Poles left out because their points do not move in phase.
void warn_about_complex(const std::vector<std::complex<double>>& poles,
                        const IdentifyOptions& options,
                        std::vector<std::string>& warnings);

/// Poles that are not the same in all FRFs.
void warn_about_shifting(const std::vector<std::complex<double>>& poles,
                         std::vector<std::string>& warnings);

/// Poles left out because they may have no damping.
void warn_about_unresolved(const std::vector<std::complex<double>>& poles,
                           std::vector<std::string>& warnings);

/// Modes that share a pole.
void warn_about_shared(const ModesOfPole& modes,
                       std::vector<std::string>& warnings);

}  // namespace tapfit::modal
