#!/bin/sh
#SBATCH --array=0-2
#SBATCH --cpus-per-task=4
#SBATCH --time=00:30:00
part=$SLURM_ARRAY_TASK_ID
build/examples/examples/07_experiments --first "${part}00" --last "${part}99" --output parts
