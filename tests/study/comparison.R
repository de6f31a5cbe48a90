# Makes comparison.csv, which comparison_test.cpp holds our comparisons against:
#   Rscript tests/study/comparison.R > tests/study/comparison.csv
# Nine days of two seeds. Two variants with four and five settings, some of them dominated; on two days they have no idle
# km in common. Lower hulls by grDevices::chull, means over idle km by integrate, intervals by t.test.
set.seed(20200517)
line <- function(kind, ...) cat(paste(c(kind, sapply(c(...), format, digits = 15)), collapse = ","), "\n", sep = "")

rows <- NULL
for (day in 1:9) {
  level <- exp(rnorm(1, 5, 0.8))
  gain <- exp(rnorm(1, -0.4, 0.2))
  for (variant in c("ref", "new")) for (setting in seq_len(if (variant == "ref") 5 else 4)) for (seed in 1:2) {
    km <- 10 + 3 * setting + rnorm(1, 0, 0.5) + if (variant == "new") (if (day %in% c(4, 8)) 30 else 2) else 0
    lost <- rpois(1, level * (if (variant == "new") gain else 1) * exp(-(km - 13) / 10) * (if (setting == 3) 1.3 else 1))
    rows <- rbind(rows, data.frame(day, variant, setting, seed, km = round(km, 3), lost, wait = round(lost / level + 2, 4)))
  }
}
for (i in seq_len(nrow(rows))) with(rows[i, ], line(variant, day, setting, seed, km, lost, wait))

corners <- function(x, y) {  # the positions of the lower left hull's corners, by x
  if (length(x) == 1) return(1)
  hull <- chull(x, y)
  at <- hull[order(x[hull], y[hull])]
  left <- at[1]
  for (i in at[-1]) {  # below the chord from the leftmost point to the lowest one, and falling
    lowest <- at[which.min(y[at])]
    chord <- y[left[1]] + (y[lowest] - y[left[1]]) * (x[i] - x[left[1]]) / (x[lowest] - x[left[1]])
    if (x[i] <= x[lowest] && y[i] <= chord + 1e-9 && y[i] < y[left[length(left)]]) left <- c(left, i)
  }
  left
}

front <- function(part, metric, by) {
  sums <- aggregate(cbind(km, lost, wait) ~ setting, part, sum)
  at <- corners(sums$km, sums$lost)
  list(x = sums$km[at], y = sums[[metric]][at] / by, all = sums$km)
}

compare <- function(kind, metric, relative, settings) {
  by <- if (relative) 1 else 2
  results <- NULL; value <- 0; reference <- 0; covered <- 0; apart <- 0; inside <- 0; points <- 0
  for (d in 1:9) {
    a <- front(subset(rows, day == d & variant == "new" & setting %in% settings), metric, by)
    b <- front(subset(rows, day == d & variant == "ref"), metric, by)
    points <- points + length(a$all)
    inside <- inside + sum(a$all >= min(b$x) & a$all <= max(b$x))
    from <- max(min(a$x), min(b$x)); to <- min(max(a$x), max(b$x))
    if (from > to || (from == to && length(settings) > 1)) { apart <- apart + 1; next }
    at <- function(f, x) if (length(f$x) == 1) rep(f$y, length(x)) else approx(f$x, f$y, x)$y
    cuts <- sort(unique(c(from, to, Filter(function(x) x > from && x < to, c(a$x, b$x)))))
    mean_of <- function(f) if (from == to) f(from) else sum(sapply(seq_along(cuts)[-1], function(i)
      integrate(f, cuts[i - 1], cuts[i], rel.tol = 1e-11)$value)) / (to - from)
    value <- value + mean_of(function(x) at(a, x)); reference <- reference + mean_of(function(x) at(b, x))
    covered <- covered + (to - from) / (max(b$x) - min(b$x))
    results <- c(results, if (relative) mean_of(function(x) log((at(a, x) + 0.5) / (at(b, x) + 0.5)))
                          else mean_of(function(x) at(a, x) - at(b, x)))
  }
  days <- length(results)
  test <- t.test(results)
  back <- if (relative) function(x) exp(x) - 1 else identity
  sums <- if (relative) c(value, reference) else c(value, reference) / days
  line(kind, days, apart, points, inside, covered / days, sums, back(test$estimate), back(test$conf.int), test$p.value)
}

compare("fronts", "lost", TRUE, 1:4)
compare("frozen", "lost", TRUE, 2)
compare("waits", "wait", FALSE, 1:4)
