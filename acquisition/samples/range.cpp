#include "acquisition/samples/range.hpp"

#include <algorithm>

namespace tapfit::acquisition {

Range range_of(const Eigen::Ref<const Eigen::VectorXd>& x) {
  // Eight at a time, so that the processor need not wait for the one before.
  using Eight = Eigen::Array<double, 8, 1>;
  Range range;
  Eight low = Eight::Constant(range.low);
  Eight high = Eight::Constant(range.high);
  const Eigen::Index n = x.size();
  Eigen::Index i = 0;
  for (; i + 8 <= n; i += 8) {
    const Eigen::Map<const Eight> values(x.data() + i);
    low = low.min(values);
    high = high.max(values);
  }
  range = {low.minCoeff(), high.maxCoeff()};
  for (; i < n; ++i) {
    range.low = std::min(range.low, x[i]);
    range.high = std::max(range.high, x[i]);
  }
  return range;
}

std::vector<Range> piece_ranges(const Eigen::Ref<const Eigen::VectorXd>& x) {
  std::vector<Range> pieces;
  pieces.reserve(static_cast<std::size_t>(x.size() / piece_length + 1));
  for (Eigen::Index i = 0; i < x.size(); i += piece_length) {
    pieces.push_back(
        range_of(x.segment(i, std::min(piece_length, x.size() - i))));
  }
  return pieces;
}

Range joined(const std::vector<Range>& pieces) {
  Range all;
  for (const Range& piece : pieces) {
    all = {std::min(all.low, piece.low), std::max(all.high, piece.high)};
  }
  return all;
}

}  // namespace tapfit::acquisition
