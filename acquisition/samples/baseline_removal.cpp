#include "acquisition/samples/baseline_removal.hpp"

#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// A median of so many is as good as one of all.
constexpr Index enough = 512;

}  // namespace

BaselineFree::BaselineFree(const Eigen::VectorXd& values)
    : samples_(values.data()),
      size_(values.size()),
      length_(static_cast<double>(values.size())),
      lines_{{0.0, 0.0, values.size()}} {}

BaselineFree::BaselineFree(const Eigen::Ref<const Eigen::VectorXd>& channel,
                           Index segment)
    : samples_(channel.data()), size_(channel.size()) {
  const Index count = std::max<Index>(1, size_ / segment);
  length_ = static_cast<double>(size_) / static_cast<double>(count);
  Eigen::VectorXd medians(count);
  for (Index k = 0; k < count; ++k) {
    const Index from = k * size_ / count;
    const Index to = (k + 1) * size_ / count;
    medians[k] =
        median(acquisition::thinned(channel.segment(from, to - from), enough));
  }
  for (Index next = 0; next <= count; ++next) {
    const Index left = std::max<Index>(0, next - 1);
    const Index right = std::min(next, count - 1);
    const double middle = (static_cast<double>(left) + 0.5) * length_;
    const double slope = (medians[right] - medians[left]) / length_;
    const double end = (static_cast<double>(next) + 0.5) * length_;
    lines_.push_back(
        {medians[left] - slope * middle,
         slope,
         next == count ? size_ : static_cast<Index>(std::ceil(end))});
  }
}

std::size_t BaselineFree::line_at(Index i) const {
  const double middles = static_cast<double>(i) / length_ + 0.5;
  return std::min(static_cast<std::size_t>(middles), lines_.size() - 1);
}

double BaselineFree::drift_on(const Line& line, Index i) {
  return line.start + line.slope * static_cast<double>(i);
}

double BaselineFree::operator[](Index i) const {
  return sign_ * (samples_[i] - drift_on(lines_[line_at(i)], i));
}

void BaselineFree::copy(Index first, Eigen::Ref<Eigen::VectorXd> out) const {
  Index done = 0;
  for (std::size_t k = line_at(first); done < out.size(); ++k) {
    const Line& line = lines_[k];
    const Index from = first + done;
    const Index count = std::min(line.end - from, out.size() - done);
    // None where rounding has put `first` on a line that ends there.
    if (count <= 0) continue;
    out.segment(done, count) =
        sign_ *
        (Eigen::VectorXd::Map(samples_ + from, count) -
         Eigen::VectorXd::LinSpaced(
             count, drift_on(line, from), drift_on(line, from + count - 1)));
    done += count;
  }
}

Eigen::VectorXd BaselineFree::segment(Index first, Index count) const {
  Eigen::VectorXd values(count);
  if (count > 0) copy(first, values);
  return values;
}

Eigen::VectorXd BaselineFree::thinned(Index most) const {
  const std::vector<Index> places = thinned_places(size_, most);
  Eigen::VectorXd values(std::ssize(places));
  for (Index k = 0; k < values.size(); ++k) {
    values[k] = (*this)[places[static_cast<std::size_t>(k)]];
  }
  return values;
}

std::vector<Range> BaselineFree::pieces() const {
  const Eigen::Map<const Eigen::VectorXd> samples(samples_, size_);
  std::vector<Range> pieces = piece_ranges(samples);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Index first = piece_length * static_cast<Index>(p);
    const Index last = std::min(first + piece_length, size_) - 1;
    // Drift is largest and smallest at the piece's ends, or where lines meet.
    Range drift;
    const auto take = [&](std::size_t line, Index at) {
      const double value = drift_on(lines_[line], at);
      drift = {std::min(drift.low, value), std::max(drift.high, value)};
    };
    const std::size_t end = line_at(last);
    take(line_at(first), first);
    for (std::size_t k = line_at(first); k < end; ++k) take(k, lines_[k].end);
    take(end, last);
    Range& piece = pieces[p];
    piece = {piece.low - drift.high, piece.high - drift.low};
    if (sign_ < 0.0) piece = {-piece.high, -piece.low};
  }
  return pieces;
}

}  // namespace tapfit::acquisition
