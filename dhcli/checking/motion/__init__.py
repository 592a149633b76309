"""What the questions about motion share: what is asked, columns and mistakes in them, reading and marking."""
