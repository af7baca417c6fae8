% No tests.
