:- begin_tests(warning).

test(singleton) :- Unused = 1.

:- end_tests(warning).
