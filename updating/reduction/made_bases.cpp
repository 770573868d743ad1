#include "updating/reduction/made_bases.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;

namespace {

Index numbers_in(const ReducedBase& base) {
  const auto matrices =
      static_cast<Index>(1 + 2 * base.K_part.size() + 2 * base.terms.size());
  return base.rows.own_numbers() + matrices * base.size() * base.size();
}

}  // namespace

std::shared_ptr<const ReducedBase> MadeBases::find(
    const BaseRequest& request) const {
  const std::scoped_lock lock(mutex_);
  const auto at = std::ranges::find(made_, request, &Made::request);
  return at == made_.end() ? nullptr : at->base;
}

void MadeBases::keep(BaseRequest request,
                     std::shared_ptr<const ReducedBase> base) {
  const Index numbers = numbers_in(*base);
  const std::scoped_lock lock(mutex_);
  made_.push_back({std::move(request), std::move(base), numbers});
  numbers_ += numbers;
  while (numbers_ > most_numbers) {
    numbers_ -= made_.front().numbers;
    made_.pop_front();
  }
}

}  // namespace tapfit::updating
