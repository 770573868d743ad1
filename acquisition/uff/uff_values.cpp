#include "acquisition/uff/uff_values.hpp"

#include "acquisition/uff/uff_numbers.hpp"

#include <algorithm>
#include <cassert>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

}  // namespace

UffValues::UffValues(const UffDataset& dataset, const UffHeader& header)
    : dataset_(&dataset), is_double_(header.is_double), count_(header.count) {
  assert(header.even && !header.complex);
}

Index UffValues::read(Eigen::Ref<Eigen::VectorXd> values) {
  const std::size_t from = at_;
  const Index wanted = std::min(values.size(), count_ - done_);
  const Index there = dataset_->binary ? read_bytes(values.head(wanted))
                                       : read_text(values.head(wanted));
  done_ += there;
  passed_ = dataset_->data.substr(from, at_ - from);
  if (there == wanted) return there;
  throw uff_cut_off(*dataset_,
                    static_cast<std::size_t>(done_),
                    static_cast<std::size_t>(count_));
}

Index UffValues::read_text(Eigen::Ref<Eigen::VectorXd> values) {
  Index filled = 0;
  while (filled < values.size()) {
    if (given_ < rest_.size()) {
      values[filled++] = rest_[given_++];
      continue;
    }
    if (at_ >= dataset_->data.size()) break;
    rest_.clear();
    given_ = 0;
    take_uff_line(
        *dataset_, next_line(dataset_->data, at_), ++line_, is_double_, rest_);
  }
  at_ = std::min(at_, dataset_->data.size());
  return filled;
}

Index UffValues::read_bytes(Eigen::Ref<Eigen::VectorXd> values) {
  const std::size_t size = is_double_ ? 8 : 4;
  const auto there = static_cast<Index>((dataset_->data.size() - at_) / size);
  const Index count = std::min(there, values.size());
  const char* from = dataset_->data.data() + at_;
  const bool big = dataset_->big_endian;
  if (is_double_) {
    for (Index i = 0; i < count; ++i) values[i] = uff_double(from + 8 * i, big);
  } else {
    for (Index i = 0; i < count; ++i) values[i] = uff_single(from + 4 * i, big);
  }
  at_ += static_cast<std::size_t>(count) * size;
  return count;
}

}  // namespace tapfit::acquisition
