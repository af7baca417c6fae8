:- module(test_typical_models, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(typical_models)).

rows([row('http://x/Bed', 'http://x/Ward'), row('http://x/Cup', 'http://x/Ward'),
      row('http://x/Cup', 'http://x/Kitchen')]).

:- begin_tests(typical_models).

test(rooms_at_or_below, Places == here(['http://x/Ward'])) :-
    rows(Rows),
    places_for('http://x/SickRoom', Rows, Places).
test(the_nearest_kind_of_room_above, Places == as('http://x/Ward')) :-
    rows(Rows),
    places_for('http://x/IntensiveWard', Rows, Places).
test(an_unknown_room, Places == unknown) :-
    rows(Rows),
    places_for('http://x/Cave', Rows, Places).
test(an_unbound_room, error(instantiation_error)) :-
    places_for(_, [], _).

test(rows_of_the_class_and_below, Evidence == rows(['http://x/Bed', 'http://x/Cot'])) :-
    evidence(kind('http://x/Bed', []), ['http://x/Bed', 'http://x/Cot', 'http://x/Cup'], Evidence).
test(the_nearest_class_above, Evidence == as('http://x/Bed')) :-
    evidence(kind('http://x/Cot', []), ['http://x/Furniture', 'http://x/Bed'], Evidence).
test(what_the_description_says_is_above, Evidence == as('http://x/Bed')) :-
    evidence(kind('http://y/NewBed', ['http://x/Bed']), ['http://x/Furniture', 'http://x/Bed'],
             Evidence).
test(no_evidence, Evidence == none) :-
    evidence(kind('http://x/Cup', []), ['http://x/Bed'], Evidence).
test(an_unbound_class, error(instantiation_error)) :-
    evidence(kind(_, []), [], _).

test(any_robot, Use == any) :-
    use(algorithm('http://x/Surf', ['http://x/Surf']), '', Use).
test(the_robot_has_it, Use == has('http://x/Features')) :-
    use(algorithm('http://x/Features', ['http://x/Features']), 'http://x/surfer', Use).
test(the_robot_has_a_more_general_one, Use == perhaps('http://x/Surf', Recognition)) :-
    Recognition = 'https://w3id.org/lares#ObjectRecognitionComponent',
    use(algorithm('http://x/Surf', ['http://x/Surf']), 'http://x/vague', Use).
test(the_robot_has_another, Use == lacks(['http://x/Surf'])) :-
    use(algorithm('http://x/Surf', ['http://x/Surf']), 'http://x/orbit', Use).
test(the_very_component, Use == has('http://x/orb1')) :-
    use(algorithm('http://x/orb1', []), 'http://x/orbit', Use).
test(unstated_wants_some_recogniser, Use == has(Recognition)) :-
    Recognition = 'https://w3id.org/lares#ObjectRecognitionComponent',
    use(algorithm('', []), 'http://x/orbit', Use).
test(unstated_and_no_recogniser, Use == lacks([Recognition])) :-
    Recognition = 'https://w3id.org/lares#ObjectRecognitionComponent',
    use(algorithm('', []), 'http://x/blind', Use).

test(all_at_once, Choice == choice(here(['http://x/Ward']),
                                   [rows(['http://x/Bed']), none],
                                   [any])) :-
    rows(Rows),
    choose('http://x/Ward', Rows, [kind('http://x/Bed', []), kind('http://x/Pan', [])],
           [algorithm('', [])], '', Choice).

:- end_tests(typical_models).
