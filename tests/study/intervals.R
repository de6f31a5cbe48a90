# Makes intervals.csv, which intervals_test.cpp holds our statistics against:
#   Rscript tests/study/intervals.R > tests/study/intervals.csv
# Seven days with three seeds each; t.test on the days' means, quantiles of Student's t, and
# linear interpolation that does not extrapolate.
set.seed(20200517)
days <- 7
effect <- rnorm(days, -0.2, 0.1)
values <- round(rep(effect, each = 3) + rnorm(3 * days, 0, 0.05), 4)
day <- rep(seq_len(days), each = 3)
means <- tapply(values, day, mean)
line <- function(kind, ...) cat(paste(c(kind, sapply(c(...), format, digits = 15)), collapse = ","), "\n", sep = "")

for (i in seq_along(values)) line("value", day[i], values[i])
test <- t.test(means)
line("t", test$estimate, test$conf.int)
for (degrees in c(1, 2, 6, 13, 100)) line("student", 0.95, degrees, qt(0.975, degrees))
line("student", 0.5, 6, qt(0.75, 6))

line("p", test$p.value)
line("p", t.test(means + 0.19)$p.value)
family <- c(0.011, 0.0004, 0.2, 0.012, 0.9, 0.011)
line("family", family)
line("holm", p.adjust(family, "holm"))

x <- c(3.5, 1, 4, 1, 5, 9, 2.5)
y <- c(2, 7, 1, 8, 2, 8, 1)
line("ranks_x", x)
line("ranks_y", y)
line("ranks", cor(x, y, method = "spearman"))

cost <- c(19000, 11500, 16000, 14000.5)
lost <- c(210, 402, 260, 311)
for (i in seq_along(cost)) line("point", cost[i], lost[i])
for (at in c(11499, 11500, 12345, 14000.5, 17500, 19000, 19001)) {
  found <- approx(cost, lost, at, rule = 1)$y
  if (is.na(found)) cat("outside,", at, "\n", sep = "") else line("at", at, found)
}
