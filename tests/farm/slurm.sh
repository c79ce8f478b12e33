#!/bin/bash
# SPDX-License-Identifier: MIT
# A real Slurm on this machine only, without systemd: munged, slurmctld and several slurmd, which
# are its nodes node1, node2, ... For tests of array jobs and of nodes that die.
#
#   slurm.sh DIR start [NODES [CPUS]]   3 nodes with 4 CPUs each, whatever the machine has
#   slurm.sh DIR kill NODE              a power cut: SIGKILL to its slurmd, slurmstepds and jobs
#   slurm.sh DIR node NODE              switches NODE on again
#   slurm.sh DIR stop                   ends everything, jobs included
#
# DIR has all that the daemons write; nothing outside is touched. SLURM_CONF=DIR/slurm.conf in the
# environment leads sbatch, srun, squeue and scontrol there. The daemons end by themselves when the
# process that called `start` has gone. Needs slurm-wlm and munge as Debian 12 builds them.
set -eu
usage="usage: $0 DIR start [NODES [CPUS]] | kill NODE | node NODE | stop"
dir=$(mkdir -p "${1:?$usage}" && cd "$1" && pwd)
command=${2:?$usage}
export SLURM_CONF=$dir/slurm.conf
socket=$dir/munge/socket

say() { echo "slurm.sh: $*" >&2; }

# wait_for SECONDS COMMAND...: until the command succeeds
wait_for()
{
    local end=$((SECONDS + $1))
    shift
    until "$@" >"$dir/wait.log" 2>&1; do
        if [ $SECONDS -ge $end ]; then
            say "gave up waiting for: $*"
            cat "$dir/wait.log" >&2
            return 1
        fi
        sleep 0.1
    done
}

# listening PORT: whether any process of this machine listens there
listening()
{
    awk -v port="$(printf '%04X' "$1")" 'split($2, a, ":") == 2 && a[2] == port && $4 == "0A" {n++}
        END {exit !n}' /proc/net/tcp /proc/net/tcp6 2>/dev/null
}

# free_ports COUNT: the first of so many ports in a row that are free, below those that systems
# hand out by themselves
free_ports()
{
    local first=$((16000 + $$ % 1000 * 16)) port
    for ((port = first; port < first + $1; port++)); do
        if listening $port; then
            first=$((port + 1))
        fi
    done
    echo $first
}

write_conf() # NODES CPUS
{
    local host port n
    host=$(hostname -s)
    port=$(free_ports $(($1 + 1)))
    cat >"$SLURM_CONF" <<END
ClusterName=farm
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
# Only this machine may connect.
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
CredType=cred/munge
# A job that is requeued waits as long as credentials live, by default two minutes.
AuthInfo=socket=$socket,cred_expire=10
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool/%n
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/%n.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/%n.log
# No systemd, no cgroups, no data base
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
# The lines below say how many CPUs there are, not the hardware.
SlurmdParameters=config_overrides
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=1,sched_interval=2,bf_interval=2
# A node that dies is missed after seconds, and may come back.
MessageTimeout=4
SlurmdTimeout=6
ReturnToService=2
# Jobs have to ask for it.
JobRequeue=0
KillWait=2
MinJobAge=3600
END
    for ((n = 1; n <= $1; n++)); do
        echo "NodeName=node$n NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + n)) CPUs=$2"
    done >>"$SLURM_CONF"
    echo "PartitionName=all Nodes=node[1-$1] Default=YES MaxTime=INFINITE State=UP" >>"$SLURM_CONF"
}

# is PID NAME: whether the process is there and is what its number was noted for,
# and not a dead one that nobody has waited for.
is() { grep -q "^$1 ($2) [^ZX]" "/proc/$1/stat" 2>/dev/null; }

gone() { ! is "$@"; }

# end PIDFILE NAME: ends a daemon, if it runs
end()
{
    local pid
    pid=$(cat "$1" 2>/dev/null) || return 0
    if is "$pid" "$2"; then
        kill "$pid" || true
        wait_for 10 gone "$pid" "$2" || kill -9 "$pid" || true
    fi
    rm -f "$1"
}

start_munged()
{
    if [ ${#socket} -gt 100 ]; then
        say "$socket: too long for the name of a socket"
        return 1
    fi
    mkdir -p "$dir/munge"
    chmod 755 "$dir/munge"
    (umask 077 && head -c 128 /dev/urandom >"$dir/munge/key")
    # --force: whoever owns the directories above
    munged --force --key-file="$dir/munge/key" --socket="$socket" --seed-file="$dir/munge/seed" \
        --pid-file="$dir/munge/pid" --log-file="$dir/munge/log" 2>"$dir/munge/warnings" ||
        { cat "$dir/munge/warnings" >&2; return 1; }
    wait_for 10 munge --no-input --socket="$socket"
}

all_idle() # NODES
{
    [ "$(sinfo --noheader --Node --format=%N --states=idle | wc -l)" = "$1" ]
}

start() # NODES CPUS
{
    local n owner=$PPID
    stop
    rm -rf "${dir:?}/state" "$dir/spool" "$dir/munge" "$dir"/*.log
    mkdir -p "$dir/state" "$dir/spool"
    write_conf "$1" "$2"
    start_munged
    slurmctld
    wait_for 10 scontrol ping
    for ((n = 1; n <= $1; n++)); do
        mkdir -p "$dir/spool/node$n"
        slurmd -N "node$n"
    done
    wait_for 30 all_idle "$1"
    # In a session of its own: what ends the caller may end its children too.
    setsid bash "$0" "$dir" guard "$owner" </dev/null >/dev/null 2>&1 &
    echo $! >"$dir/guard.pid"
}

# with_environment VARIABLE FILE...: those of the files /proc/N/environ that have the variable
with_environment() { grep -lszxF -- "$@" || true; }

# What jobs run has SLURMD_NODENAME in its environment; slurmstepd, which started it, has not.
kill_node() # NODE
{
    local file pid parent jobs=() steps=()
    for file in $(with_environment "SLURMD_NODENAME=$1" /proc/[0-9]*/environ); do
        if [ -n "$(with_environment "SLURM_CONF=$SLURM_CONF" "$file")" ]; then
            pid=$(basename "${file%/environ}")
            jobs+=("$pid")
            parent=$(awk '$1 == "PPid:" {print $2}' "/proc/$pid/status" 2>/dev/null) || true
            is "${parent:-0}" slurmstepd && steps+=("$parent")
        fi
    done
    pid=$(cat "$dir/$1.pid" 2>/dev/null) && is "$pid" slurmd && steps+=("$pid")
    # Those first that would report the end of the others
    for pid in "${steps[@]}" "${jobs[@]}"; do
        kill -9 "$pid" 2>/dev/null || true
    done
    rm -f "$dir/$1.pid"
}

stop()
{
    local file
    for file in "$dir"/node*.pid; do
        [ -e "$file" ] && kill_node "$(basename "$file" .pid)"
    done
    end "$dir/slurmctld.pid" slurmctld
    end "$dir/munge/pid" munged
    end "$dir/guard.pid" bash
}

guard() # PROCESS
{
    while kill -0 "$1" 2>/dev/null; do
        sleep 1
    done
    stop
}

case $command in
start) start "${3:-3}" "${4:-4}" ;;
kill) kill_node "${3:?$usage}" ;;
node) slurmd -N "${3:?$usage}" ;;
stop) stop ;;
guard) guard "${3:?$usage}" ;;
*) echo "$usage" >&2 && exit 2 ;;
esac
