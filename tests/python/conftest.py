"""Lets the tests find devices.py, wherever pytest is called."""

import os
import sys

sys.path.insert(0, os.path.dirname(__file__))
