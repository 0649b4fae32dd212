// The source that tests' precompiled header is made for: it holds nothing else.
