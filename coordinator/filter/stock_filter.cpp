#include "coordinator/filter/stock_filter.hpp"

#include <mrpt/bayes/CKalmanFilterCapable.h>

#include <vector>

namespace evbal {
namespace {

constexpr double of_a_report = 1e-4;  ///< variance of a count that is believed
constexpr int total_row = stocks;     ///< of the observations, which are the stocks and their total
constexpr int rows = stocks + 1;

using Mask = Eigen::Matrix<double, 1, stocks>;

Mask of_total() {
  Mask mask = Mask::Ones();
  mask(static_cast<int>(CarKind::occupied_due)) = 0.0;
  return mask;
}

using Base = mrpt::bayes::CKalmanFilterCapable<stocks, rows, 0, stocks>;

}  // namespace

/// Predicts in one iteration and observes in another, since MRPT's iteration does both. A row that is not observed has
/// a zero Jacobian: then its gain is zero, which is how this base class can do without it.
class StockFilter::Kalman : public Base {
 public:
  Kalman(const StockVector& counts, const StockVector& variances) {
    m_xkk.resize(stocks);
    m_pkk.setSize(stocks, stocks);
    m_xkk.asEigen() = counts;
    m_pkk.asEigen() = StockMatrix(variances.asDiagonal());
  }

  void predict(const StockVector& change, const StockMatrix& noise) {
    change_ = change;
    noise_ = noise;
    predicting_ = true;
    runOneKalmanIteration();
    predicting_ = false;
  }

  void observe(int row, const Mask& of, double count, double variance) {
    jacobian_.row(row) = of;
    seen_(row) = count;
    variances_(row) = variance;
  }

  void update() {
    runOneKalmanIteration();
    jacobian_.setZero();
    seen_.setZero();
    variances_.setOnes();
  }

  StockVector counts() const { return m_xkk.asEigen(); }
  StockMatrix covariance() const { return m_pkk.asEigen(); }

 protected:
  void OnGetAction(KFArray_ACT& action) const override { action.asEigen() = change_; }

  void OnTransitionModel(const KFArray_ACT& action, KFArray_VEH& state, bool& skip_prediction) const override {
    skip_prediction = !predicting_;
    if (predicting_) {
      state.asEigen() += action.asEigen();
    }
  }

  void OnTransitionJacobian(KFMatrix_VxV& jacobian) const override { jacobian.setIdentity(); }

  void OnTransitionNoise(KFMatrix_VxV& noise) const override { noise.asEigen() = noise_; }

  void OnGetObservationNoise(KFMatrix_OxO& noise) const override {
    noise.asEigen() = variances_.asDiagonal().toDenseMatrix();
  }

  void OnGetObservationsAndDataAssociation(vector_KFArray_OBS& observations, std::vector<int>& /*of_features*/,
                                           const vector_KFArray_OBS& /*predicted*/, const KFMatrix& /*covariance*/,
                                           const std::vector<std::size_t>& /*features*/,
                                           const KFMatrix_OxO& /*noise*/) override {
    observations.resize(predicting_ ? 0 : 1);
    for (auto& observation : observations) {
      observation.asEigen() = seen_;
    }
  }

  void OnObservationModel(const std::vector<std::size_t>& /*features*/, vector_KFArray_OBS& predicted) const override {
    predicted.resize(1);
    predicted.front().asEigen() = jacobian_ * m_xkk.asEigen();
  }

  void OnObservationJacobians(std::size_t /*feature*/, KFMatrix_OxV& jacobian,
                              KFMatrix_OxF& /*of_feature*/) const override {
    jacobian.asEigen() = jacobian_;
  }

 private:
  bool predicting_ = false;
  StockVector change_ = StockVector::Zero();
  StockMatrix noise_ = StockMatrix::Zero();
  Eigen::Matrix<double, rows, stocks> jacobian_ = Eigen::Matrix<double, rows, stocks>::Zero();
  Eigen::Matrix<double, rows, 1> seen_ = Eigen::Matrix<double, rows, 1>::Zero();
  Eigen::Matrix<double, rows, 1> variances_ = Eigen::Matrix<double, rows, 1>::Ones();
};

StockFilter::StockFilter(const StockVector& counts, const StockVector& variances)
    : kalman_(std::make_unique<Kalman>(counts, variances)) {}
StockFilter::StockFilter(StockFilter&&) noexcept = default;
StockFilter& StockFilter::operator=(StockFilter&&) noexcept = default;
StockFilter::~StockFilter() = default;

void StockFilter::predict(const StockVector& change, const StockMatrix& noise) {
  kalman_->predict(change, noise);
}

void StockFilter::observe(const std::array<std::optional<double>, stocks>& counts) {
  for (int row = 0; row < stocks; ++row) {
    if (const auto count = counts.at(static_cast<std::size_t>(row))) {
      kalman_->observe(row, Mask::Unit(row), *count, of_a_report);
    }
  }
  kalman_->update();
}

void StockFilter::observe_total(double vehicles, double variance) {
  kalman_->observe(total_row, of_total(), vehicles, variance + of_a_report);
  kalman_->update();
}

StockVector StockFilter::counts() const {
  return kalman_->counts();
}

StockMatrix StockFilter::covariance() const {
  return kalman_->covariance();
}

double total(const StockVector& counts) {
  return of_total().dot(counts);
}

double total_variance(const StockMatrix& covariance) {
  return of_total() * covariance * of_total().transpose();
}

}  // namespace evbal
