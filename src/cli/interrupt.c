/* SPDX-License-Identifier: MIT
 *
 * Signal handlers that do nothing but remember.
 */
#include "interrupt.h"

#include <signal.h>
#include <stddef.h>
#ifndef _WIN32
#include <unistd.h>
#endif

static volatile sig_atomic_t requested;

#ifdef _WIN32
static void remember(int number)
{
    requested = number;
}

static void watch(int number)
{
    signal(number, remember);
}
#else
/* The signal may come just before a write that then waits for ever: an alarm ends that one, and
   further ones whatever may still wait. */
static void remember(int number)
{
    if (requested == 0) {
        requested = number;
    }
    alarm(1);
}

/* A write that waits, into a pipe for instance, must not be taken up again: no SA_RESTART. What is
   ignored already, as by nohup, stays so. */
static void watch(int number)
{
    struct sigaction action;
    if (sigaction(number, NULL, &action) == 0 && action.sa_handler != SIG_IGN) {
        action.sa_handler = remember;
        action.sa_flags = 0;
        sigemptyset(&action.sa_mask);
        sigaction(number, &action, NULL);
    }
}
#endif

void interrupt_install(void)
{
    watch(SIGINT);
    watch(SIGTERM);
#ifdef SIGHUP
    watch(SIGHUP);
#endif
#ifdef SIGALRM
    watch(SIGALRM);
#endif
#ifdef SIGPIPE
    signal(SIGPIPE, SIG_IGN);
#endif
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
}

bool interrupted(void)
{
    return requested != 0;
}

void interrupt_end(void)
{
    if (requested != 0) {
        signal(requested, SIG_DFL);
        raise(requested);
    }
}
