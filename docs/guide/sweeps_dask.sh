#!/bin/sh
#SBATCH --ntasks=16
#SBATCH --time=01:00:00

# The scheduler's port depends on the job, since jobs may share a node
export DASK_SCHEDULER_ADDRESS="tcp://$SLURMD_NODENAME:$((20000 + SLURM_JOB_ID % 10000))"
python -m dask scheduler --port "${DASK_SCHEDULER_ADDRESS##*:}" &
srun python -m dask worker --nthreads 1 &
python sweeps_dask.py
