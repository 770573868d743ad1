#include "acquisition/bundle/recording_stream.hpp"

#include <algorithm>
#include <cassert>

namespace tapfit::acquisition {

using Eigen::Index;

RecordingStream::RecordingStream(const TestBundle& bundle,
                                 const Run& run,
                                 const UffFile* uff)
    : bundle_(bundle), run_(run), uff_(uff), dead_(bundle, run) {
  if (run.datasets.empty()) {
    audio_.emplace(run.file);
    rate_ = audio_->sample_rate_hz();
    samples_ = audio_->samples();
    check_channels(bundle, run, audio_->channels());
  } else {
    open_uff_records();
  }
  check_band(bundle, rate_, run.file.string());
}

void RecordingStream::open_uff_records() {
  assert(uff_ != nullptr);
  for (const UffSource& source : run_.datasets) {
    const UffDataset& dataset = dataset_of(*uff_, source.dataset);
    const UffHeader header =
        uff_->bytes.reading([&dataset] { return read_header(dataset); });
    rate_ = rate_of(header);
    samples_ = header.count;
    records_.emplace_back(dataset, header);
  }
}

void RecordingStream::read_uff_records(Eigen::Ref<Eigen::MatrixXd> out) {
  if (static_cast<Index>(records_.size()) < out.cols()) out.setZero();
  for (std::size_t k = 0; k < records_.size(); ++k) {
    const UffSource& source = run_.datasets[k];
    auto column = out.col(static_cast<Index>(source.channel));
    uff_->bytes.reading([this, k, &column] {
      records_[k].read(column);
      return true;
    });
    uff_->bytes.forget(records_[k].passed());
    if (source.unit_to_si != 1.0) column *= source.unit_to_si;
  }
}

Index RecordingStream::read(Eigen::Ref<Eigen::MatrixXd> out) {
  const Index count = std::min(out.rows(), samples_ - done_);
  auto rows = out.topRows(count);
  if (audio_) {
    audio_->read(rows, full_scales(bundle_));
  } else {
    read_uff_records(rows);
  }
  if (!audio_ || audio_->floating_point()) {
    check_finite(rows, done_, rate_, bundle_, run_.file.string());
  }
  dead_.look_at(rows);
  done_ += count;
  if (done_ == samples_) dead_.refuse();
  return count;
}

}  // namespace tapfit::acquisition
