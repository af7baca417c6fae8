:- begin_tests(failing).

test(fails, fail) :- true.

:- end_tests(failing).
