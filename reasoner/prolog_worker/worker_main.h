// The program of a worker process.
#pragma once

namespace lares::prolog {

// The first argument of a program that is to be a worker, and where it finds its socket.
inline constexpr const char* kWorkerCommand = "prolog-worker";
inline constexpr int kWorkerSocket = 3;

// Starts Prolog, waits for one request on kWorkerSocket, confines the process, answers, and ends
// the process; without a server on the socket it ends it at once. Called before anything else
// starts a thread.
[[noreturn]] void RunWorker();

}  // namespace lares::prolog
