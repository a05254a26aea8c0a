#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The study of README.md runs as the array job of overroll-study(5) on a real
# Slurm with one node, which this test starts and stops. The job is cancelled
# halfway and submitted again. The collected table equals the table of `sweep -j
# 2`.
. "$TOP/tests/support/cli.sh"
need slurmctld slurmd sbatch munged
[ "$(id -u)" -eq 0 ] || skip 'Slurm is started as root only'

stop_slurm() {
    for name in slurmd slurmctld munged; do
        [ -s "$here/$name.pid" ] && kill "$(cat "$here/$name.pid")" 2>/dev/null
    done
    sleep 1
}

# until SECONDS COMMAND...: tries it until it holds.
until_true() {
    left=$(($1 * 5))
    shift
    until "$@"; do
        left=$((left - 1))
        [ $left -gt 0 ] || return 1
        sleep 0.2
    done
}

# ------------------------------------------------------- a cluster of one node
here=$PWD
trap stop_slurm EXIT
chmod 755 "$here" # munge's socket is for all
mkdir munge state spool
chmod 700 munge state
dd if=/dev/urandom of=munge/key bs=128 count=1 2>/dev/null
chmod 600 munge/key
munged --force --socket="$here/munged.socket" --key-file="$here/munge/key" \
    --pid-file="$here/munged.pid" --log-file="$here/munge/log" \
    --seed-file="$here/munge/seed" || fail "$(cat munge/log)"

name=$(hostname -s) port=$((20000 + $$ % 20000))
cat >slurm.conf <<END
ClusterName=overroll
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$here/munged.socket
CredType=cred/munge
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.pid
SlurmctldLogFile=$here/slurmctld.log
SlurmdLogFile=$here/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
KillWait=30
NodeName=$name NodeAddr=127.0.0.1 CPUs=2 Boards=1 SocketsPerBoard=1 \\
 CoresPerSocket=2 ThreadsPerCore=1 State=UNKNOWN
PartitionName=all Nodes=$name Default=YES MaxTime=INFINITE State=UP \\
 OverSubscribe=NO
END
export SLURM_CONF="$here/slurm.conf"
slurmctld || fail 'slurmctld'
slurmd -N "$name" || slurmd || fail 'slurmd'
node_is_idle() {
    sinfo -h -o %t 2>/dev/null | grep -q idle
}
until_true 60 node_is_idle ||
    fail "no node: $(sinfo 2>&1; tail -n 3 slurmctld.log slurmd.log)"

# ----------------------------------------------------------- README's commands
mkdir bin alone cluster
ln -s "$OVERROLL" bin/overroll
PATH=$here/bin:$PATH
sed -n '/^```sh$/,/^```$/p' "$TOP/README.md" | grep -v '^```' >tour
grep -q '^overroll sweep study.ini -j 2$' tour ||
    fail 'README has another study'
# Its case and study, on a finer grid, so that the cases take long enough to be
# cancelled.
for folder in alone cluster; do
    (cd $folder && overroll init roller -o roller.ini -q &&
        sed -n '/^cat >study.ini/,/^END/p' "$here/tour" |
        sed "s/^domain.level = .*/domain.level = ${LEVEL:-8}/" | sh -eu) ||
        fail "README's study cannot be made"
done
cd "$here/alone" || exit 1
expect 0 overroll sweep study.ini -j 2 -q
expect 0 overroll sweep study.ini --collect table.csv -q

cd "$here/cluster" || exit 1
sed -n '/^\.\\" slurm$/,/^\.EE/p' "$TOP/src/run/overroll-study.5" |
    grep -v '^\.' | sed 's/\\-/-/g' >job
grep -q '^#SBATCH .*--array=1-8' job || fail "the array job: $(cat job)"

finished() {
    find study -name '*.json' 2>/dev/null | wc -l
}
half_way() { # and in the middle of a run
    [ "$(finished)" -ge 2 ] &&
        [ "$(find study -name '*.h5' | wc -l)" -gt "$(finished)" ]
}
nothing_runs() {
    [ -z "$(squeue -h)" ]
}
expect 0 sbatch job
job=$(awk '{ print $NF }' out)
until_true 600 half_way || fail "$(squeue; cat slurm-*.out)"
expect 0 scancel "$job"
until_true 120 nothing_runs || fail "$(squeue)"
before=$(finished)
[ "$before" -lt 8 ] || fail 'all had finished when it was cancelled'
expect 3 overroll sweep study.ini --collect half.csv
half=$(grep '8 cases: ' out)
echo "$half" | grep -q stopped || fail "no run was stopped: $half"

expect 0 sbatch job
until_true 900 nothing_runs || fail "$(squeue)"
expect 0 overroll sweep study.ini --collect table.csv -q

# But for what depends on the clock.
numbers() {
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "seconds") s = i }
        { $s = ""; print }' "$1"
}
numbers table.csv >table.txt
numbers ../alone/table.csv | cmp - table.txt ||
    fail "Slurm computes another thing: $(
        numbers ../alone/table.csv | diff - table.txt | head -n 6)"
echo "cancelled: $half; then the same table"
