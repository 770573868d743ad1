// One run's samples in physical units, piece by piece.
#pragma once

#include "acquisition/bundle/dead_channels.hpp"
#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/uff/uff_values.hpp"

#include <optional>
#include <vector>

namespace tapfit::acquisition {

class RecordingStream {
 public:
  /// @param uff the bundle's universal file, where it is one; it has to outlive
  ///   the stream
  /// @throws InputError as read_recording
  RecordingStream(const TestBundle& bundle, const Run& run, const UffFile* uff);

  [[nodiscard]] double sample_rate_hz() const { return rate_; }
  [[nodiscard]] Eigen::Index samples() const { return samples_; }

  /// The next samples [SI], as many as `out` has rows, fewer at the end.
  ///
  /// @param out rows x channels of the bundle
  /// @throws InputError for a file that ends early, a sample that is not
  /// finite,
  ///   and at the end for a channel in use that has had but one value
  Eigen::Index read(Eigen::Ref<Eigen::MatrixXd> out);

 private:
  void open_uff_records();
  void read_uff_records(Eigen::Ref<Eigen::MatrixXd> out);

  const TestBundle& bundle_;
  const Run& run_;
  const UffFile* uff_;
  DeadChannels dead_;
  std::optional<AudioReader> audio_;
  std::vector<UffValues> records_;  ///< as Run::datasets
  double rate_ = 0.0;
  Eigen::Index samples_ = 0;
  Eigen::Index done_ = 0;
};

}  // namespace tapfit::acquisition
