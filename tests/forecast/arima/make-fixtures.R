#!/usr/bin/env Rscript
# Writes series, and what R's `arima` (4.2) says of them by exact Gaussian maximum likelihood, for arima_test.cpp:
#   Rscript make-fixtures.R > fixtures.json

set.seed(20200517)

numbers <- function(x) paste0("[", paste(ifelse(is.na(x), "null", sprintf("%.12g", x)), collapse = ","), "]")

part <- function(coefficients, prefix) numbers(coefficients[grepl(paste0("^", prefix, "[0-9]+$"), names(coefficients))])

# `stretches` are days with nothing in common: R gets them as one series with long gaps in between.
entry <- function(name, stretches, order, seasonal = c(0, 0, 0), period = 1) {
  gap <- rep(NA, 2000)
  series <- stretches[[1]]
  for (stretch in stretches[-1]) series <- c(series, gap, stretch)
  fit <- arima(series, order = order, seasonal = list(order = seasonal, period = period), include.mean = FALSE,
               method = "ML", SSinit = "Rossignol2011", optim.control = list(reltol = 1e-15, maxit = 2000))
  ahead <- predict(fit, n.ahead = 5)
  cat(sprintf('{"name": "%s", "order": %s, "seasonal": %s, "period": %d,\n', name, numbers(order), numbers(seasonal),
              period))
  cat(sprintf(' "stretches": [%s],\n', paste(sapply(stretches, numbers), collapse = ",\n  ")))
  cat(sprintf(' "ar": %s, "ma": %s, "seasonal_ar": %s, "seasonal_ma": %s, "variance": %.12g,\n', part(fit$coef, "ar"),
              part(fit$coef, "ma"), part(fit$coef, "sar"), part(fit$coef, "sma"), fit$sigma2))
  cat(sprintf(' "log_likelihood": %.12g, "mean_ahead": %s, "deviation_ahead": %s}', fit$loglik,
              numbers(as.numeric(ahead$pred)), numbers(as.numeric(ahead$se))))
}

with_gaps <- function(x, share) replace(x, sample(length(x), round(share * length(x))), NA)
round3 <- function(x) round(as.numeric(x), 3)

ar1 <- round3(arima.sim(list(ar = 0.8), 200))
arma11 <- round3(arima.sim(list(ar = 0.9, ma = -0.6), 400, sd = 2))
arma21 <- round3(arima.sim(list(ar = c(1.1, -0.3), ma = 0.4), 300))
ma2 <- round3(arima.sim(list(ma = c(0.5, 0.3)), 250))
days <- lapply(1:6, function(day) round3(arima.sim(list(ar = 0.85, ma = -0.5), 38)))
seasonal <- round3(arima.sim(list(ar = c(0.6, rep(0, 10), 0.5, -0.3)), 240))
walk <- round3(cumsum(arima.sim(list(ar = 0.4, ma = 0.3), 150)))
# A profile that drifts from day to day.
profiles <- apply(matrix(rnorm(38 * 10, sd = 0.6), 38), 1, cumsum)
weeks <- round3(10 + 5 * sin(2 * pi * (1:380) / 38) + as.numeric(t(profiles)) + arima.sim(list(ar = 0.7), 380))

cat("[")
entry("ar1", list(ar1), c(1, 0, 0)); cat(",\n")
entry("arma11", list(arma11), c(1, 0, 1)); cat(",\n")
entry("arma21", list(arma21), c(2, 0, 1)); cat(",\n")
entry("ma2", list(ma2), c(0, 0, 2)); cat(",\n")
entry("gaps", list(with_gaps(arma11, 0.2)), c(1, 0, 1)); cat(",\n")
entry("days", days, c(1, 0, 1)); cat(",\n")
entry("seasonal", list(seasonal), c(1, 0, 0), c(1, 0, 0), 12); cat(",\n")
entry("differenced", list(diff(walk)), c(1, 0, 1)); cat(",\n")
entry("walk", list(walk), c(1, 1, 1)); cat(",\n")
entry("differenced by 38", list(round3(diff(weeks, 38))), c(1, 0, 0), c(0, 0, 1), 38); cat(",\n")
entry("period of 38", list(weeks), c(1, 0, 0), c(0, 1, 1), 38); cat(",\n")
entry("walk with gaps", list(with_gaps(walk, 0.1)), c(0, 1, 1))
cat("]\n")
