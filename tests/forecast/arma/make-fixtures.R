#!/usr/bin/env Rscript
# Writes series, and what R's `arima` (4.2) says of them by exact Gaussian maximum likelihood, for arma_test.cpp:
#   Rscript make-fixtures.R > fixtures.json

set.seed(20200517)

numbers <- function(x) paste0("[", paste(ifelse(is.na(x), "null", sprintf("%.12g", x)), collapse = ","), "]")

part <- function(coefficients, prefix) numbers(coefficients[grepl(paste0("^", prefix, "[0-9]+$"), names(coefficients))])

# `stretches` are days with nothing in common: R gets them as one series with long gaps in between.
entry <- function(name, stretches, p, q) {
  gap <- rep(NA, 2000)
  series <- stretches[[1]]
  for (stretch in stretches[-1]) series <- c(series, gap, stretch)
  fit <- arima(series, order = c(p, 0, q), include.mean = FALSE, method = "ML", SSinit = "Rossignol2011",
               optim.control = list(reltol = 1e-15, maxit = 2000))
  ahead <- predict(fit, n.ahead = 5)
  cat(sprintf('{"name": "%s", "p": %d, "q": %d,\n', name, p, q))
  cat(sprintf(' "stretches": [%s],\n', paste(sapply(stretches, numbers), collapse = ",\n  ")))
  cat(sprintf(' "ar": %s, "ma": %s, "variance": %.12g,\n', part(fit$coef, "ar"), part(fit$coef, "ma"), fit$sigma2))
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

cat("[")
entry("ar1", list(ar1), 1, 0); cat(",\n")
entry("arma11", list(arma11), 1, 1); cat(",\n")
entry("arma21", list(arma21), 2, 1); cat(",\n")
entry("ma2", list(ma2), 0, 2); cat(",\n")
entry("gaps", list(with_gaps(arma11, 0.2)), 1, 1); cat(",\n")
entry("days", days, 1, 1)
cat("]\n")
