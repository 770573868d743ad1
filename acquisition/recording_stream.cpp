#include "acquisition/recording_stream.hpp"

#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::acquisition {

using Eigen::Index;

RecordingStream::RecordingStream(const TestBundle& bundle, const Run& run)
    : bundle_(bundle), file_(run.file.string()) {
  if (!run.datasets.empty()) {
    whole_ = read_recording(bundle, run);
    rate_ = whole_.sample_rate_hz;
    samples_ = whole_.samples.rows();
    return;
  }
  audio_.emplace(run.file);
  rate_ = audio_->sample_rate_hz();
  samples_ = audio_->samples();
  check_channels(bundle, run, audio_->channels());
  check_band(bundle, rate_, file_);
}

Index RecordingStream::read(Eigen::Ref<Eigen::MatrixXd> out) {
  if (!audio_) {
    const Index count = std::min(out.rows(), samples_ - done_);
    out.topRows(count) = whole_.samples.middleRows(done_, count);
    done_ += count;
    return count;
  }
  const Index count = audio_->read(out, full_scales(bundle_));
  if (audio_->floating_point()) {
    check_finite(out.topRows(count), done_, rate_, bundle_, file_);
  }
  done_ += count;
  return count;
}

}  // namespace tapfit::acquisition
