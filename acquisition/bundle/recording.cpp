#include "acquisition/bundle/recording.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::acquisition {

void check_finite(const Eigen::Ref<const Eigen::MatrixXd>& samples,
                  Eigen::Index first,
                  double rate,
                  const TestBundle& bundle,
                  const std::string& file) {
  // One sum per column shows what is not finite without looking at each.
  if (std::isfinite(samples.sum())) return;
  for (Eigen::Index c = 0; c < samples.cols(); ++c) {
    for (Eigen::Index i = 0; i < samples.rows(); ++i) {
      if (std::isfinite(samples(i, c))) continue;
      throw InputError(
          fmt::format("channel \"{}\" is not a number at {:.6f} s",
                      bundle.channels[static_cast<std::size_t>(c)].name,
                      static_cast<double>(first + i) / rate),
          file,
          "record or export the file again, or leave this run out");
    }
  }
}

Eigen::RowVectorXd full_scales(const TestBundle& bundle) {
  Eigen::RowVectorXd scale(static_cast<Eigen::Index>(bundle.channels.size()));
  for (Eigen::Index c = 0; c < scale.size(); ++c) {
    scale(c) = bundle.channels[static_cast<std::size_t>(c)].full_scale_si();
  }
  return scale;
}

void check_channels(const TestBundle& bundle,
                    const Run& run,
                    Eigen::Index channels) {
  if (channels == static_cast<Eigen::Index>(bundle.channels.size())) return;
  throw InputError(fmt::format("has {} channels, test.json lists {}",
                               channels,
                               bundle.channels.size()),
                   run.file.string(),
                   "list in `channels` every channel of the file, in order");
}

void check_band(const TestBundle& bundle,
                double rate,
                const std::string& file) {
  if (!bundle.band_hz || (*bundle.band_hz)[1] < 0.5 * rate) return;
  throw InputError(
      fmt::format("the band ends at {} Hz, but {} is sampled at {} Hz and "
                  "holds only frequencies below {} Hz",
                  (*bundle.band_hz)[1],
                  file,
                  rate,
                  0.5 * rate),
      "test.json: band_hz",
      "lower the band's upper end");
}

}  // namespace tapfit::acquisition
