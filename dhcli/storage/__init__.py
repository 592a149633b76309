"""What dhcli writes: files whole or not at all, the folders of a user, and what is kept there to be had sooner."""
