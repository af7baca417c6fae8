:- module(edge,
          [ error_text/2,               % +Exception, -Text
            load_test_file/1            % +File
          ]).

/** <module> What the C++ side of the edge asks of Prolog
*/

%!  error_text(+Exception, -Text:string) is det.
%
%   The message that Prolog would print for an uncaught Exception.

error_text(Exception, Text) :-
    catch('$messages':message_to_string(Exception, Text), _, fail),
    !.
error_text(Exception, Text) :-
    Options = [quoted(true), max_depth(20)],
    format(string(Text), 'Unknown exception: ~W', [Exception, Options]).

%!  load_test_file(+File:atom) is det.
%
%   Loads File over the bundled rules.

load_test_file(File) :-
    load_files(user:File, [imports([])]).
