# What wilcox.test of R says of 200 pairs of samples of all kinds, as rows of
# tests/data/rank_sums.tsv:
#   Rscript tests/runtime/report/rank_sums.R > tests/data/rank_sums.tsv
# Run by hand, so that neither plsc nor its tests need R.

Row <- function(why, x, y) {
  t <- suppressWarnings(wilcox.test(x, y))
  cat(sprintf("%s\t%s\t%s\t%.17g\t%.17g\t%s\n", why,
              paste(x, collapse = ","), paste(y, collapse = ","), t$statistic,
              t$p.value, grepl("exact", t$method)))
}

# Distinct values; those of x are the greater ones, the less noise the more.
Apart <- function(n, m, noise) {
  all <- sample(1:999, n + m)
  x <- order(all + noise * runif(n + m), decreasing = TRUE)[1:n]
  list(all[x], all[-x])
}

set.seed(20)
cat("# What wilcox.test(x, y) of R says: W, two-sided p, whether it is exact.\n",
    "# Made by tests/runtime/report/rank_sums.R with ",
    R.version.string, ".\n# why\tx\ty\tW\tp\texact\n", sep = "")
for (i in 1:80) {
  pair <- Apart(sample(1:49, 1), sample(1:49, 1), c(600, 5000)[i %% 2 + 1])
  Row(paste("exact", i), pair[[1]], pair[[2]])
}
for (i in 1:20)
  Row(paste("ends of the exact tail", i), 1:(i + 5), (i + 4):(3 * i + 2) + 1.5)
for (i in 1:40) {
  pair <- Apart(sample(50:70, 1), sample(1:60, 1), c(600, 5000)[i %% 2 + 1])
  if (i %% 4 < 2) pair <- rev(pair)
  Row(paste("large", i), pair[[1]], pair[[2]])
}
for (i in 1:50)
  Row(paste("ties", i), sample(0:(5 + i), sample(2:30, 1), replace = TRUE),
      sample(0:(5 + i), sample(2:30, 1), replace = TRUE) + i %/% 10)
for (i in 1:10)
  Row(paste("large and with ties, far apart", i),
      sample(0:(5 + i), 50 + i, replace = TRUE),
      sample(0:(5 + i), 70, replace = TRUE) + i)
