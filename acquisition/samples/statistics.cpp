#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <numeric>

namespace tapfit::acquisition {

double median(Eigen::VectorXd values) {
  if (values.size() == 0) return 0.0;
  double* middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

double median(const std::vector<double>& values) {
  return median(Eigen::VectorXd::Map(values.data(), std::ssize(values)));
}

std::vector<Eigen::Index> thinned_places(Eigen::Index n, Eigen::Index most) {
  std::vector<Eigen::Index> places(static_cast<std::size_t>(std::min(n, most)));
  if (n <= most) {
    std::iota(places.begin(), places.end(), Eigen::Index{0});
    return places;
  }
  // 7919 is prime, so its multiples wander through a part. Parts are `least`
  // or one more long; the multiples modulo either are added up, since a
  // division takes longer than all else here.
  const Eigen::Index least = n / most;
  const Eigen::Index rest = n % most;
  const Eigen::Index steps[] = {7919 % least, 7919 % (least + 1)};
  Eigen::Index wander[] = {0, 0};
  Eigen::Index from = 0;
  Eigen::Index over = 0;  // k n modulo `most`
  for (Eigen::Index& place : places) {
    over += rest;
    const bool longer = over >= most;
    if (longer) over -= most;
    place = from + wander[longer ? 1 : 0];
    from += least + (longer ? 1 : 0);
    for (Eigen::Index j = 0; j < 2; ++j) {
      wander[j] += steps[j];
      if (wander[j] >= least + j) wander[j] -= least + j;
    }
  }
  return places;
}

Eigen::VectorXd thinned(const Eigen::Ref<const Eigen::VectorXd>& values,
                        Eigen::Index most) {
  return values(thinned_places(values.size(), most));
}

}  // namespace tapfit::acquisition
