"""What the commands share: the streams, options, the way of a result to its reader, and walks through an exercise."""
