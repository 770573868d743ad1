// One run's samples in physical units, piece by piece.
#pragma once

#include "acquisition/audio_file.hpp"
#include "acquisition/recording.hpp"

#include <optional>

namespace tapfit::acquisition {

class RecordingStream {
 public:
  /// A sound file is streamed; a universal file's run is read at once.
  /// @throws InputError as read_recording
  RecordingStream(const TestBundle& bundle, const Run& run);

  [[nodiscard]] double sample_rate_hz() const { return rate_; }
  [[nodiscard]] Eigen::Index samples() const { return samples_; }

  /// The next samples [SI], as many as `out` has rows, fewer at the end.
  ///
  /// @param out rows x channels of the bundle
  /// @throws InputError for a file that ends early, a sample that is not finite
  Eigen::Index read(Eigen::Ref<Eigen::MatrixXd> out);

 private:
  const TestBundle& bundle_;
  std::string file_;
  std::optional<AudioReader> audio_;
  Recording whole_;
  double rate_ = 0.0;
  Eigen::Index samples_ = 0;
  Eigen::Index done_ = 0;
};

}  // namespace tapfit::acquisition
