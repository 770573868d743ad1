#include "updating/fit/updater.hpp"

#include "updating/fit/fit_observer.hpp"
#include "updating/residual/independent_data.hpp"
#include "updating/residual/parameter_uncertainty.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXd;

namespace {

// One fit on its way: what its steps left.
class Updating {
 public:
  Updating(const FrfModel& model,
           const Target& target,
           const ModelState& like,
           const Prior& prior,
           const MinimiseOptions& options,
           const Progress& progress)
      : model_(&model),
        target_(&target),
        like_(&like),
        prior_(&prior),
        options_(options),
        progress_(&progress) {}

  [[nodiscard]] std::optional<Minimum> minimum(const VectorXd& start) {
    return minimise([this](const VectorXd& theta) { return evaluate(theta); },
                    *prior_,
                    [this](const VectorXd& r) { return count_data(r); },
                    start,
                    options_,
                    [this](const Iterate& point) { return take(point); });
  }

  [[nodiscard]] std::vector<UpdateStep> history() && {
    return std::move(history_);
  }

 private:
  [[nodiscard]] std::optional<Residuals> evaluate(const VectorXd& theta) {
    ModelResponse response =
        model_->respond(unpack(*like_, theta), target_->s, true);
    if (!response.H.allFinite()) return std::nullopt;
    Residuals at{residual(*target_, response.H), {}};
    at.J.resize(at.r.size(), theta.size());
    for (std::size_t k = 0; k < response.dH.size(); ++k) {
      at.J.col(static_cast<Index>(k)) = stack(*target_, response.dH[k]);
    }
    H_ = std::move(response.H);
    return at;
  }

  // What is no noise, mesh and form of the deck, is in step over lines and
  // FRFs: taken for as many data as there are lines it would overrule what is
  // known beforehand, and be explained by whatever may move.
  double count_data(const VectorXd& r) {
    data_ = independent_data(*target_, r);
    return data_;
  }

  // The point is where the model was evaluated last.
  bool take(const Iterate& point) {
    const bool first = history_.empty();
    const double error = error_of(*target_, point.at.r);
    history_.push_back(
        {error, point.moved, error / std::sqrt(data_), point.theta});
    const auto steps = static_cast<double>(history_.size() - 1);
    (*progress_)("updating", steps / options_.most_steps);
    if (first) return true;
    const FitObserver* observer = fit_observer(*progress_);
    if (observer != nullptr && observer->step) {
      observer->step(
          {history_.back(),
           *model_,
           *target_,
           *prior_,
           unpack(*like_, point.theta),
           H_,
           parameter_covariance(*target_,
                                point.at.J,
                                point.at.r,
                                prior_->sd,
                                known_slopes(*prior_, point.theta))});
    }
    return !is_enough(*progress_);
  }

  const FrfModel* model_;
  const Target* target_;
  const ModelState* like_;
  const Prior* prior_;
  MinimiseOptions options_;
  const Progress* progress_;
  double data_ = 1.0;
  MatrixXcd H_;
  std::vector<UpdateStep> history_;
};

}  // namespace

UpdateResult update(const FrfModel& model,
                    const Target& target,
                    const ModelState& start,
                    const Prior& prior,
                    const MinimiseOptions& options,
                    const Progress& progress) {
  UpdateResult result;
  Updating updating(model, target, start, prior, options, progress);
  const VectorXd first =
      pack(start).cwiseMax(prior.lower).cwiseMin(prior.upper);
  result.state = unpack(start, first);
  std::optional<Minimum> found = updating.minimum(first);
  if (!found) {
    result.message = "the model's FRFs are not finite at the start";
    return result;
  }
  Iterate& at = found->point;
  result.state = unpack(start, at.theta);
  result.error = error_of(target, at.at.r);
  result.objective = at.objective;
  result.prior_cost = at.prior_cost;
  result.covariance = parameter_covariance(
      target, at.at.J, at.at.r, prior.sd, known_slopes(prior, at.theta));
  result.jacobian = std::move(at.at.J);
  result.residual = std::move(at.at.r);
  result.prior = prior;
  result.lambda = result.error / std::sqrt(found->data);
  result.history = std::move(updating).history();
  result.converged = found->converged;
  result.message = std::move(found->message);
  return result;
}

}  // namespace tapfit::updating
