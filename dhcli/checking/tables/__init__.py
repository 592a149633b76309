"""DH tables as answers: read in any spelling, judged by their cells or by the motion they describe."""
