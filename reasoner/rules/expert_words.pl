:- module(expert_words, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(error)).
:- use_module(library(lists)).
:- use_module(library(ordsets)).
:- use_module(library(pairs)).
:- use_module(library(solution_sequences)).
:- use_module(library(yall)).
:- use_module(rules(availability)).
:- use_module(rules(classes)).
:- use_module(rules(matching)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(recipes)).
:- use_module(rules(templates)).

/** <module> The words that an expert's goal may use

Goals are called in this module: what it imports is what they can name beside Prolog's own
built-ins. It defines nothing.
*/
