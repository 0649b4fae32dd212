# What R says of the statistics that claims rest on, as rows of
# tests/data/claim_statistics.tsv:
#   Rscript tests/runtime/report/claim_statistics.R > tests/data/claim_statistics.tsv
# Run by hand, so that neither plsc nor its tests need R. Holm's correction and
# the limits of shares are R's own; A is R's W / (n m); intervals by bootstrap are
# written here anew (R's base has none), with ten times as many replicates.

Row <- function(kind, x, y, ...)
  cat(sprintf("%s\t%s\t%s\t%s\n", kind, paste(x, collapse = ","),
              paste(y, collapse = ","),
              paste(sprintf("%.17g", c(...)), collapse = "\t")))

kReplicates <- 100000

Percentile <- function(t) quantile(t, c(0.025, 0.975), names = FALSE)

# Of the estimate, its replicates, and by sample what it is without each value.
Bca <- function(t0, t, without) {
  z0 <- qnorm(mean(t < t0) + mean(t == t0) / 2)
  top <- 0
  bottom <- 0
  for (w in without) {
    n <- length(w)
    l <- (n - 1) * (mean(w) - w)
    top <- top + sum(l^3) / n^3
    bottom <- bottom + sum(l^2) / n^2
  }
  a <- if (bottom > 0) top / (6 * bottom^1.5) else 0
  z <- z0 + qnorm(c(0.025, 0.975))
  quantile(t, pnorm(z0 + z / (1 - a * z)), names = FALSE)
}

A <- function(x, y) {
  r <- rank(c(x, y))
  n <- length(x)
  (sum(r[1:n]) - n * (n + 1) / 2) / (n * length(y))
}

Superiority <- function(x, y) {
  w <- suppressWarnings(wilcox.test(x, y))$statistic
  stopifnot(abs(w / (length(x) * length(y)) - A(x, y)) < 1e-12)
  t <- replicate(kReplicates, A(x[sample.int(length(x), replace = TRUE)],
                                y[sample.int(length(y), replace = TRUE)]))
  without <- list(sapply(seq_along(x), function(i) A(x[-i], y)),
                  sapply(seq_along(y), function(i) A(x, y[-i])))
  Row("superiority", x, y, w / (length(x) * length(y)), Bca(A(x, y), t, without))
}

Paired <- function(x, y) {
  d <- (sign(x - y) + 1) / 2
  t <- colMeans(matrix(sample(d, length(d) * kReplicates, TRUE), length(d)))
  without <- list(sapply(seq_along(d), function(i) mean(d[-i])))
  Row("paired", x, y, mean(d), Bca(mean(d), t, without))
}

Value <- function(x) {
  drawn <- matrix(sample(x, length(x) * kReplicates, TRUE), length(x))
  Row("median", x, "", median(x), Percentile(apply(drawn, 2, median)))
  without <- list(sapply(seq_along(x), function(i) mean(x[-i])))
  Row("mean", x, "", mean(x), Bca(mean(x), colMeans(drawn), without))
}

set.seed(2611)
cat("# What R says of the statistics of claims. Made by\n",
    "# tests/runtime/report/claim_statistics.R with ", R.version.string,
    ".\n# kind\tx\ty\tvalue\tand its interval\n", sep = "")
for (n in c(4, 7, 10, 20, 20, 33)) {
  Superiority(round(rnorm(n, 1), 3), round(rnorm(n + n %% 3), 3))
  Superiority(round(rexp(n), 3), round(rexp(n + 2), 3))
}
for (i in 1:4)
  Superiority(sample(0:4, 15, TRUE), sample((0:3) + i %/% 3, 12, TRUE))
for (n in c(6, 12, 20, 31)) {
  Paired(round(rnorm(n, 0.5), 2), round(rnorm(n), 2))
  Value(round(rlnorm(n), 3))
}
for (n in c(1, 2, 6, 12, 17)) {
  p <- signif(runif(n)^4, 4)
  if (n > 6) p[3] <- p[5]
  Row("holm", p, n, p.adjust(p, "holm"))
  p <- signif(runif(n)^4, 4)
  Row("holm", p, n + 3, p.adjust(p, "holm", n + 3))
}
for (n in c(1, 5, 6, 20, 80))
  for (k in unique(c(0, 1, n %/% 2, n - 1, n)))
    Row("share", k, n, k / n, binom.test(k, n)$conf.int)
