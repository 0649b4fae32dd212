"""An experiment and a study that are done at once, for tests of processes."""

EXPERIMENT = """plsc_experiment: 1
name: tiny
population: 4
offspring: 4
generations: 2
scenario:
  seasons: [{name: flat, terrain: flat, duration: 1 s}]
"""


def study(repetitions):
    return f"""plsc_study: 1
name: tiny
seed: 1
repetitions: {repetitions}
base:
  population: 4
  offspring: 4
  generations: 2
  scenario:
    seasons: [{{name: flat, terrain: flat, duration: 1 s}}]
experiments:
  one: {{encoding: plasticoding}}
"""
