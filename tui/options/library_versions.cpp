#include "tui/options/library_versions.hpp"

#include "acquisition/readers/audio_file.hpp"
#include "acquisition/readers/inflate.hpp"
#include "acquisition/readers/mat_file.hpp"
#include "signal/spectra/fft.hpp"
#include "tui/screen/terminal.hpp"
#include "updating/structure/solve/factor.hpp"

#include <CLI/Version.hpp>
#include <Spectra/Util/Version.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

std::vector<std::pair<std::string, std::string>> library_versions() {
  const auto version = [](int major, int minor, int patch) {
    return fmt::format("{}.{}.{}", major, minor, patch);
  };
  return {
      {"tapfit", TAPFIT_VERSION},
      {"Eigen",
       version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"FFTW", signal::fft_library()},
      {"CHOLMOD", structure::sparse_library()},
      {"Spectra",
       version(SPECTRA_MAJOR_VERSION,
               SPECTRA_MINOR_VERSION,
               SPECTRA_PATCH_VERSION)},
      {"libsndfile", acquisition::sound_library()},
      {"matio", acquisition::matlab_library()},
      {"zlib", acquisition::packing_library()},
      {"ncurses", terminal_library()},
      {"fmt",
       version(
           FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann-json",
       version(NLOHMANN_JSON_VERSION_MAJOR,
               NLOHMANN_JSON_VERSION_MINOR,
               NLOHMANN_JSON_VERSION_PATCH)},
      {"CLI11", CLI11_VERSION},
  };
}

}  // namespace tapfit::tui
