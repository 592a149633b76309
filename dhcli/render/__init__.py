"""Any result as text for people or programs, chosen by the name of a format; nothing is computed here."""
